// How much of a surface triangles on it cover together.
//
// In:  a mesh, one of its planar surfaces (surface_of in facet_plane.h), and triangles on it, corners as the labelled
//      surface has them. They may lie on and across each other, be narrow or flat, and have either orientation.
// Out: the share of the surface's area that their union has; 0 for a surface that is narrower than the grid below, and
//      for that no error is known.
// Method: surface and triangles are seen along the axis in which the surface is seen largest. Its bounding rectangle is
//      mapped to the window, where the corners are rounded to the grid, once. From there on the triangles are sheets of
//      paper at one height, and what the sweep sees of them is the union, exactly.
// Error: with n triangles, m triangles in the fans of the surface's facets, and S of the window's area 4 in the
//      surface, the share is off by less than 2^-37 (n + m) / S. For rounding moves a corner by at most d = 2^-41
//      sqrt(2) in the window, so that an edge of length L passes over at most d (L + 2 d). A triangle's three have 4 +
//      sqrt(8) together at most, which is 4.9 * 2^-40 per triangle; up to 8 * 2^-40 remains for the mapping and for
//      sums in double.
// Complexity: that of the sweep: O((k + c) log k) for k triangles whose edges cross c times.
// Errors: InternalError.
#pragma once

#include <array>
#include <span>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/export.h"

namespace sightline::inline coverage {

using SpaceTriangle = std::array<Point3, 3>;

struct UnionShare {
  double share = 0;
  double error = 0;  // the bound above
};

[[nodiscard]] SIGHTLINE_EXPORT UnionShare union_share(const CutMesh& mesh, FacetId surface,
                                                      std::span<const SpaceTriangle> triangles);

}  // namespace sightline::inline coverage
