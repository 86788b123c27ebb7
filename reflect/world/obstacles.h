// What may stand between a mirror and a panel: the facets of the surface, and the panels.
//
// In:  meshes. Out: per pyramid, the facets that may have a point in it.
// Complexity: O(n log n) to build; a pyramid (pyramid.h) costs what it touches of the hierarchy.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/mesh.h"

namespace sightline::inline reflect {

class Obstacles {
 public:
  Obstacles() = default;
  // A mesh that was cut along common lines has the facets before the cut as obstacles. Which pieces they are in is of
  // no interest here.
  explicit Obstacles(const Mesh& mesh);

  // `may_touch` is false where a box has no point in the pyramid.
  [[nodiscard]] std::vector<WholeId> in(const std::function<bool(const Box&)>& may_touch) const;

 private:
  BoxHierarchy hierarchy_;
};

// Returns the corners of a whole: of a facet, where the mesh was not cut.
[[nodiscard]] std::span<const VertexId> whole_corners(const Mesh& mesh, WholeId whole);

[[nodiscard]] Box box_of(const Mesh& mesh, std::span<const VertexId> corners);

}  // namespace sightline::inline reflect
