#include "cli/labelled_obj.h"

#include "cli/text_buffer.h"

namespace sightline {

namespace {

void write_triangle(const LabelledTriangle& triangle, TextBuffer& out) {
  out << 'f';
  for (const VertexId corner : triangle.corners) out << ' ' << std::uint64_t{corner.index()} + 1;
  out << '\n';
}

// The triangles come by face already.
void write_group(const LabelledMesh& labelled, Label label, TextBuffer& out) {
  out << "g " << to_string(label) << '\n';
  for (const LabelledTriangle& triangle : labelled.triangles) {
    if (triangle.label == label) write_triangle(triangle, out);
  }
}

}  // namespace

std::string labelled_obj(const LabelledMesh& labelled) {
  TextBuffer out;
  out << "# sightline: the refined surface, one group per label\n";
  for (const Point3& p : labelled.vertices) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const Label label : {Label::back_facing, Label::out_of_view, Label::hidden, Label::visible}) {
    write_group(labelled, label, out);
  }
  return out.take();
}

}  // namespace sightline
