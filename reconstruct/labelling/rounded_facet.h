// What rounding to the grid has made of a facet's image.
//
// In:  a projected facet in view.
// Out: whether its rounded polygon is still convex and turns as the facet does. Where it is not, the facet is narrower
//      than the grid. Straight sides that rounding bends, within the grid, do not count.
#pragma once

#include "geometry/mesh/cut_mesh.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline reconstruct {

[[nodiscard]] bool is_proper(const ProjectedScene& scene, FacetId facet);

}  // namespace sightline::inline reconstruct
