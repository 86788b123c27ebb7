#include "formats/writing/labelled_obj.h"

#include <set>

namespace sightline::inline formats {

namespace {

void write_triangle(const LabelledTriangle& triangle, TextBuffer& out) {
  out << 'f';
  for (const VertexId corner : triangle.corners) out << ' ' << std::uint64_t{corner.index()} + 1;
  out << '\n';
}

// The triangles come by face already.
void write_group(const LabelledMesh& labelled, Label label, std::uint64_t reflecting,
                 const std::vector<std::string>& panels, TextBuffer& out) {
  out << "g " << to_string(label);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    if ((reflecting >> p & 1U) != 0) out << " reflecting_" << panels[p];
  }
  out << '\n';
  for (const LabelledTriangle& triangle : labelled.triangles) {
    if (triangle.label == label && triangle.reflecting == reflecting) write_triangle(triangle, out);
  }
}

// 0 comes first, and is always there.
std::set<std::uint64_t> reflecting_of(const LabelledMesh& labelled, Label label) {
  std::set<std::uint64_t> found{0};
  for (const LabelledTriangle& triangle : labelled.triangles) {
    if (triangle.label == label && triangle.reflecting != 0) found.insert(triangle.reflecting);
  }
  return found;
}

}  // namespace

void write_labelled_obj(const LabelledMesh& labelled, const std::vector<std::string>& panels, TextBuffer& out) {
  out << "# sightline: the refined surface, one group per label\n";
  for (const Point3& p : labelled.vertices) out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const Label label : {Label::back_facing, Label::out_of_view, Label::hidden, Label::visible}) {
    for (const std::uint64_t reflecting : reflecting_of(labelled, label))
      write_group(labelled, label, reflecting, panels, out);
  }
}

}  // namespace sightline::inline formats
