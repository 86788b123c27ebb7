// Facets that are hidden are left out by whole surfaces.
//
// In:  a mesh, its projected scene, and per facet whether it is hidden.
// Out: the same, but for the facets of a surface (facet_plane.h) some of whose facets in view may be seen: none is
// hidden. What the sweep says of a surface it says of all its facets: a segment's edge may belong to any of them, and
// where the boundary of what is visible passes an edge, the edge is split for all facets on it.
// Complexity: O(n).
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

void keep_surfaces_whole(const Mesh& mesh, const ProjectedScene& scene, std::vector<std::uint8_t>& hidden);

}  // namespace sightline::inline sweep
