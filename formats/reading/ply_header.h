// The header of a PLY file: which elements follow, how many of each, and what each of them has.
//
// ply_reader.h says what is read and refused.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "formats/reading/input_bytes.h"

namespace sightline::inline formats {

enum class PlyEncoding : std::uint8_t { text, little_endian, big_endian };

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
[[nodiscard]] std::size_t size_of(PlyType type);
[[nodiscard]] bool is_integer(PlyType type);

// What a property is to a mesh.
enum class PlyRole : std::uint8_t { none, x, y, z, nx, ny, nz, corners };

struct PlyProperty {
  PlyRole role = PlyRole::none;
  PlyType type = PlyType::float32;    // of a list: of its items
  std::optional<PlyType> count_type;  // of a list only
};

struct PlyElement {
  enum class Kind : std::uint8_t { vertex, face, other } kind = Kind::other;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties{};

  [[nodiscard]] bool has(PlyRole role) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;

  // Returns how many there are; 0 where there is no such element.
  [[nodiscard]] std::uint64_t count(PlyElement::Kind kind) const;
};

// Takes the bytes from their beginning up to the first one after the header.
[[nodiscard]] PlyHeader parse_ply_header(InputBytes& in);

}  // namespace sightline::inline formats
