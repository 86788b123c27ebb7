#include "formats/writing/labelled_ply.h"

#include <array>
#include <bit>
#include <cstring>
#include <string_view>

namespace sightline::inline formats {

namespace {

// The comments name the values of the property label.
void write_header(const LabelledMesh& labelled, const std::vector<std::string>& panels, TextBuffer& out) {
  out << "ply\nformat binary_little_endian 1.0\ncomment sightline: face = index of the input face\n";
  for (const Label label : {Label::back_facing, Label::out_of_view, Label::hidden, Label::visible}) {
    out << "comment label " << static_cast<std::uint32_t>(label) << " = " << to_string(label) << '\n';
  }
  out << "comment seen 1 = the camera sees it, from the front or from behind\n"
      << "element vertex " << std::uint64_t{labelled.vertices.size()}
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << "element face " << std::uint64_t{labelled.triangles.size()}
      << "\nproperty list uchar int vertex_indices\nproperty int face\nproperty uchar label\nproperty uchar seen\n";
  for (const std::string& panel : panels) out << "property uchar reflecting_" << panel << '\n';
  out << "end_header\n";
}

// Numbers are little endian, whatever the machine is.
template <class Unsigned>
char* put(char* at, Unsigned value) {
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(at, &value, sizeof value);
  } else {
    for (std::size_t i = 0; i < sizeof value; ++i) at[i] = static_cast<char>(value >> (8 * i) & 0xFF);
  }
  return at + sizeof value;
}

char* put(char* at, const Point3& p) {
  for (const double coordinate : {p.x(), p.y(), p.z()}) at = put(at, std::bit_cast<std::uint64_t>(coordinate));
  return at;
}

char* put(char* at, const LabelledTriangle& triangle, std::size_t panels) {
  at = put(at, std::uint8_t{3});
  for (const VertexId corner : triangle.corners) at = put(at, corner.value);
  at = put(at, triangle.face.value);
  at = put(at, static_cast<std::uint8_t>(triangle.label));
  at = put(at, static_cast<std::uint8_t>(triangle.seen ? 1 : 0));
  for (std::size_t p = 0; p < panels; ++p) at = put(at, static_cast<std::uint8_t>(triangle.reflecting >> p & 1U));
  return at;
}

}  // namespace

void write_labelled_ply(const LabelledMesh& labelled, const std::vector<std::string>& panels, TextBuffer& out) {
  write_header(labelled, panels, out);
  std::array<char, 128> bytes;  // of a vertex, or of a triangle
  static_assert(bytes.size() >= 1 + 3 * 4 + 4 + 1 + 1 + most_panels);
  const auto append = [&](const char* end) { out << std::string_view(bytes.data(), end); };
  for (const Point3& p : labelled.vertices) append(put(bytes.data(), p));
  for (const LabelledTriangle& triangle : labelled.triangles) append(put(bytes.data(), triangle, panels.size()));
}

}  // namespace sightline::inline formats
