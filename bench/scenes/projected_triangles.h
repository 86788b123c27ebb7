// The projected scene as triangles in space, for programs that know no camera.
//
// In:  a projected scene.
// Out: a fan of triangles per clipped polygon. x and y are the window's, [-1, 1]^2, exactly those of the scene's
//      points. z grows away from the viewer; it is -1 / W for a pinhole and the distance along the view direction else,
//      so that planes stay planes, up to its rounding. Triangles without area in the image are left out.
// Complexity: O(n). Errors: none.
#pragma once

#include <array>
#include <vector>

#include "geometry/numbers/vector3.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::bench {

using ProjectedTriangle = std::array<Point3, 3>;

[[nodiscard]] std::vector<ProjectedTriangle> projected_triangles(const ProjectedScene& scene);

}  // namespace sightline::bench
