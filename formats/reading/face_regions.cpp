#include "formats/reading/face_regions.h"

#include <algorithm>

#include "formats/reading/region_recorder.h"

namespace sightline::inline formats {

namespace {

std::string as_hexadecimal(char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return {'\\', 'x', digits[byte / 16], digits[byte % 16]};
}

// Controls of C0 and C1, DEL, and what breaks lines or turns the direction of writing.
bool is_control(std::uint32_t point) {
  return point < 0x20 || (point >= 0x7F && point < 0xA0) || (point >= 0x2028 && point <= 0x202E) ||
         (point >= 0x2066 && point <= 0x2069);
}

// Returns the length of the UTF-8 character at the text's front; 0 where it is none, or a control character.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return is_control(first) ? 0 : 1;
  const std::size_t length = first >= 0xF0 ? 4 : (first >= 0xE0 ? 3 : 2);
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  std::uint32_t point = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
    point = point << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = point >= 0xD800 && point <= 0xDFFF;
  return point < least[length] || point > 0x10FFFF || is_surrogate || is_control(point) ? 0 : length;
}

}  // namespace

const char* to_string(RegionKind kind) {
  switch (kind) {
    case RegionKind::mesh:
      return "mesh";
    case RegionKind::object:
      return "object";
    case RegionKind::group:
      return "group";
    case RegionKind::material:
      return "material";
    case RegionKind::smoothing:
      return "smoothing";
  }
  return "";
}

std::string region_name(std::string_view bytes) {
  std::string name;
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    const std::string next = length > 0 ? std::string(bytes.substr(0, length)) : as_hexadecimal(bytes[0]);
    if (name.size() + next.size() > longest_region_name) break;
    name += next;
    bytes.remove_prefix(std::max(length, std::size_t{1}));
  }
  return name;
}

FaceRegions unnamed_regions(std::size_t face_count) {
  RegionRecorder recorder;
  for (std::size_t f = 0; f < face_count; ++f) recorder.add_face();
  return recorder.take();
}

}  // namespace sightline::inline formats
