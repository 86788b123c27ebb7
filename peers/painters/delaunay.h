// The Delaunay triangulation of points of the image.
//
// In:  points, in any order; equal ones count once.
// Out: the triangles of their convex hull, counter-clockwise, none degenerate: no point is inside the circle through a
//      triangle's corners, exactly. None where all points are on one line. Of several triangulations through points on
//      one circle it is always the same one for the same points.
// Complexity: that of reconstruct/triangulation/constrained_delaunay.h without constraints.
// Errors: none.
#pragma once

#include <array>
#include <vector>

#include "geometry/numbers/predicates.h"

namespace sightline::peers {

using TriangleOfPoints = std::array<Point2, 3>;

[[nodiscard]] std::vector<TriangleOfPoints> delaunay(std::vector<Point2> points);

}  // namespace sightline::peers
