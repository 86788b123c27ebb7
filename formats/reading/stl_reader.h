// STL, in text and in binary: triangles, each with its own three corners.
//
// In:  the bytes. Text: `solid [name]`, facets `facet normal x y z`, `outer loop`, `vertex x y z` three times, `endloop`,
//      `endfacet`, then `endsolid [name]`; any number of solids, keywords in upper or lower case. Binary, little endian:
//      80 bytes, the number of triangles n, then 50 bytes for each.
// Out: the mesh. Corners with equal coordinates are welded, by value: no two vertices that differ in a bit become one,
//      but for 0 and -0. Vertices are numbered as they first occur. A number in text is the correctly rounded double of
//      what the file says; one in binary is a float, kept as it is.
//
// The winding says which side is the front. Normals are only compared with it: facets whose normal points against it, by
// more than 120 degrees, are counted in a warning. They are no normals of the surface (Normals::read gives none). What
// binary files have in their first 80 bytes, and in the two bytes after each triangle (colours), is passed over.
//
// What is refused (InputError, in text with the line, in binary with the byte): a file that is not as above; one that
// ends before its last solid or triangle does; a coordinate that is no number, not finite, or beyond the range of
// double; more triangles than the limit on memory allows, in binary before they are read.
//
// Complexity: O(n log n) in the number of triangles.
// Why not a library: Assimp and others hold floats only, read numbers with rounding of their own, and take a file that
// ends too soon for one that is shorter.
#pragma once

#include <cstdint>

#include "formats/reading/input_bytes.h"
#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"

namespace sightline::inline formats {

constexpr std::uint64_t stl_header_size = 84;
constexpr std::uint64_t stl_facet_size = 50;

[[nodiscard]] MeshFile read_stl_text(InputBytes& in, const ReadLimits& limits, Normals normals);
[[nodiscard]] MeshFile read_stl_binary(InputBytes& in, const ReadLimits& limits, Normals normals);

}  // namespace sightline::inline formats
