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
#include "geometry/numbers/export.h"

namespace sightline::inline reflect {

class SIGHTLINE_EXPORT Obstacles {
 public:
  Obstacles() = default;
  // Of a mesh that was cut along common lines: the facets before. Which pieces they are in is of no interest here.
  explicit Obstacles(const Mesh& mesh);

  // may_touch: false where a box has no point in the pyramid.
  [[nodiscard]] std::vector<WholeId> in(const std::function<bool(const Box&)>& may_touch) const;

 private:
  BoxHierarchy hierarchy_;
};

// The corners of a whole: of a facet, where the mesh was not cut.
[[nodiscard]] SIGHTLINE_EXPORT std::span<const VertexId> whole_corners(const Mesh& mesh, WholeId whole);

[[nodiscard]] SIGHTLINE_EXPORT Box box_of(const Mesh& mesh, std::span<const VertexId> corners);

}  // namespace sightline::inline reflect
