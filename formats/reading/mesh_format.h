// What kind of file this is, told by its first bytes; its name is not asked.
//
// In:  the first bytes of a file, and how many it has in all where that is known.
// Out: one of the formats that are read, or what other kind of file it is and what to do with it.
//
// Whatever nothing else is known of is taken for OBJ, which has no mark. Binary STL has none either: it is a file of
// 84 + 50 n bytes where the bytes from 80 on say n, even if it begins with "solid", as STL in text does.
// Complexity: O(1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sightline::inline formats {

// So many first bytes are enough.
constexpr std::size_t format_head_size = 4096;

enum class MeshFormat : std::uint8_t { obj, stl_text, stl_binary, ply, off, gltf, gltf_binary, three_mf, other };

struct FoundFormat {
  MeshFormat format = MeshFormat::obj;
  std::string refusal;  // of a file that no reader here reads: what it is, and what to do
};

[[nodiscard]] FoundFormat format_of(std::string_view head, std::optional<std::uint64_t> size);

// Returns whether the library leaves it to a reader of the command (formats/importing).
[[nodiscard]] bool is_imported(MeshFormat format);

}  // namespace sightline::inline formats
