// What may stand between a mirror and a panel: the facets of the surface, and the panels.
//
// In:  meshes. Out: per pyramid, the facets that may have a point in it.
// Complexity: O(n log n) to build; a pyramid costs what it touches of the hierarchy.
#pragma once

#include <vector>

#include "geometry/box_hierarchy.h"
#include "geometry/mesh.h"
#include "reflect/pyramid.h"

namespace sightline {

class Obstacles {
 public:
  Obstacles() = default;
  // Of a mesh that was cut along common lines: the facets before. Which pieces they are in is of no interest here.
  explicit Obstacles(const Mesh& mesh);

  [[nodiscard]] std::vector<WholeId> in(const Pyramid& pyramid) const;

 private:
  BoxHierarchy hierarchy_;
};

// The corners of a whole: of a facet, where the mesh was not cut.
[[nodiscard]] std::span<const VertexId> whole_corners(const Mesh& mesh, WholeId whole);

[[nodiscard]] Box box_of(const Mesh& mesh, std::span<const VertexId> corners);

}  // namespace sightline
