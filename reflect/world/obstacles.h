// What may be in the way of mirrored rays: the facets of the surface.
#pragma once

#include <functional>
#include <vector>

#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/cut_mesh.h"

namespace sightline::inline reflect {

// The facets of the surface, and panels, may stand between a mirror and a panel. The hierarchy is built in O(n log n);
// a pyramid (pyramid.h) costs what it touches of it.
class Obstacles {
 public:
  Obstacles() = default;
  // A mesh that was cut along common lines has the facets before the cut as obstacles. Which pieces they are in is of
  // no interest here.
  explicit Obstacles(const CutMesh& mesh);

  // `may_touch` is false where a box has no point in the pyramid.
  [[nodiscard]] std::vector<UncutFacetId> in(const std::function<bool(const Box&)>& may_touch) const;

 private:
  BoxHierarchy hierarchy_;
};

}  // namespace sightline::inline reflect
