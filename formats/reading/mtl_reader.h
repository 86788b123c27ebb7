// Wavefront MTL: what a file says of materials, as far as that matters here: the illumination model and Ks.
//
// In:  the text of an MTL file. Out: its materials by name (region_name); of several that are called alike the first one.
// What is passed over: all other statements; `illum` and `Ks` that are not made of plain decimals (`Ks spectral`, `Ks xyz`).
// Errors: std::length_error for more than longest_mtl_file bytes or most_materials materials.
// Complexity: O(bytes).
// Library: tinyobjloader reads the statements. Its decimals are off by some last bits, which does not matter for materials, as it
//      would for positions (obj_reader.h); whoever compares them should do it in float. It gets no names and no other statements
//      than these, with exponents of at most three digits: what it does on longer ones is undefined.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "formats/reading/face_regions.h"

namespace sightline::inline formats {

constexpr std::size_t longest_mtl_file = std::size_t{16} << 20;
constexpr std::size_t most_materials = 20000;

[[nodiscard]] std::map<std::string, Material> read_mtl(std::string_view text);

}  // namespace sightline::inline formats
