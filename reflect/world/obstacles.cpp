#include "reflect/world/obstacles.h"

namespace sightline::inline reflect {

std::span<const VertexId> whole_corners(const CutMesh& mesh, WholeId whole) {
  return mesh.is_cut() ? mesh.cuts.wholes[whole.index()] : mesh.corners(FacetId(whole.index()));
}

Box box_of(const CutMesh& mesh, std::span<const VertexId> corners) {
  Box box{mesh.position(corners.front()), mesh.position(corners.front())};
  for (const VertexId v : corners) box = hull(box, {mesh.position(v), mesh.position(v)});
  return box;
}

Obstacles::Obstacles(const CutMesh& mesh) {
  std::vector<Box> boxes;
  for (std::size_t w = 0; w < mesh.whole_count(); ++w) boxes.push_back(box_of(mesh, whole_corners(mesh, WholeId(w))));
  hierarchy_ = build_hierarchy(boxes);
}

std::vector<WholeId> Obstacles::in(const std::function<bool(const Box&)>& may_touch) const {
  std::vector<WholeId> found;
  for_each_touched_item(hierarchy_, may_touch, [&](const BoxHierarchy::Item& item) { found.emplace_back(item.index); });
  return found;
}

}  // namespace sightline::inline reflect
