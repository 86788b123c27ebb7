#include "reflect/obstacles.h"

namespace sightline {

std::span<const VertexId> whole_corners(const Mesh& mesh, WholeId whole) {
  return mesh.is_cut() ? mesh.cuts.wholes[whole.index()] : mesh.corners(FacetId(whole.index()));
}

Box box_of(const Mesh& mesh, std::span<const VertexId> corners) {
  Box box{mesh.position(corners.front()), mesh.position(corners.front())};
  for (const VertexId v : corners) box = hull(box, {mesh.position(v), mesh.position(v)});
  return box;
}

Obstacles::Obstacles(const Mesh& mesh) {
  std::vector<Box> boxes;
  for (std::size_t w = 0; w < mesh.whole_count(); ++w) boxes.push_back(box_of(mesh, whole_corners(mesh, WholeId(w))));
  hierarchy_ = build_hierarchy(boxes);
}

std::vector<WholeId> Obstacles::in(const Pyramid& pyramid) const {
  std::vector<WholeId> found;
  std::vector<std::uint32_t> open;
  if (!hierarchy_.nodes.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    const BoxHierarchy::Node& node = hierarchy_.nodes[n];
    if (!pyramid.may_touch(node.box)) continue;
    if (node.right != 0) {
      open.insert(open.end(), {node.right, n + 1});
      continue;
    }
    for (std::uint32_t i = node.first; i < node.end; ++i) {
      const BoxHierarchy::Item& item = hierarchy_.items[i];
      if (pyramid.may_touch(item.box)) found.emplace_back(item.index);
    }
  }
  return found;
}

}  // namespace sightline
