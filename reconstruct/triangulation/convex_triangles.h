// Triangles of a convex polygon with further points on its sides, found without coordinates.
//
// In:  the polygon's points in order, and for each the side on which the line to the next point lies.
// Out: triangles in the polygon's orientation.
// Holds: every point is a corner of a triangle, every line between neighbours the side of exactly one, and no
// triangle has its three corners on one side. Any three points on the border of a convex polygon, taken in order,
// turn its way unless they are on one side: so this is exact wherever the polygon lies.
// Precondition: at least three different sides, and the points of one side are consecutive.
// Complexity: O(n).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/numbers/ids.h"

namespace sightline::inline reconstruct {

struct BorderPoint {
  VertexId vertex;
  std::uint32_t side = 0;  // of the line to the next point
};

[[nodiscard]] std::vector<std::array<VertexId, 3>> convex_triangles(std::span<const BorderPoint> border);

}  // namespace sightline::inline reconstruct
