// The edges of a projected scene, from its facets' polygons.
//
// In:  a scene whose points, polygons and corners are known.
// Out: its edges and their sides: edges that fall on each other are one edge, with the sides in the order of facets and
//      of their corners. Edges whose ends fall on one point are none.
// Complexity: O(n log n), O(n) where few edges have one top.
#pragma once

#include "geometry/projection/projected_scene.h"

namespace sightline::inline geometry {

void collect_edges(ProjectedScene& scene);

}  // namespace sightline::inline geometry
