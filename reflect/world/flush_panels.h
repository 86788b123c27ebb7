// Panels that lie on a face of the surface, or on another panel, or all but: as a screen's panel lies in its screen.
//
// In:  the surface, its facets as obstacles, the panels as meshes, one of them, and a distance.
// Out: what lies on the panel (coincidence.h), sorted.
// Complexity: O(log n) and what comes closer to it than the distance.
#pragma once

#include <span>
#include <vector>

#include "geometry/cutting/coincidence.h"
#include "geometry/mesh/cut_mesh.h"
#include "reflect/world/obstacles.h"

namespace sightline::inline reflect {

struct FlushFacet : Coincidence {
  UncutFacetId facet;  // of the surface
};

struct FlushPanel : Coincidence {
  std::size_t panel = 0;  // another one
};

struct Flush {
  std::vector<FlushFacet> facets;
  std::vector<FlushPanel> panels;
};

[[nodiscard]] Flush find_flush(const CutMesh& surface, const Obstacles& obstacles, std::span<const CutMesh> panels,
                               std::size_t panel, double distance);

}  // namespace sightline::inline reflect
