#include "reflect/world/obstacles.h"

#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {

Obstacles::Obstacles(const CutMesh& mesh) {
  std::vector<Box> boxes;
  for (std::size_t w = 0; w < mesh.uncut_facet_count(); ++w)
    boxes.push_back(box_of(mesh, mesh.uncut_corners(UncutFacetId(w))));
  hierarchy_ = build_hierarchy(boxes);
}

std::vector<UncutFacetId> Obstacles::in(const std::function<bool(const Box&)>& may_touch) const {
  std::vector<UncutFacetId> found;
  for_each_touched_item(hierarchy_, may_touch, [&](const BoxHierarchy::Item& item) { found.emplace_back(item.index); });
  return found;
}

}  // namespace sightline::inline reflect
