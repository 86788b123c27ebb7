// A facet on its own: a convex polygon, its plane, and where points and lines lie to them.
//
// In:  a facet of a mesh: convex, planar, not degenerate. Corners on a straight side are fine.
// Out: exact signs, independent of the order in which one asks. They are those of orient3d and orient2d. In planes and
//      along lines that are parallel to an axis comparisons decide, where the filters of those predicates cannot see
//      that a determinant is zero.
#pragma once

#include <span>

#include "geometry/mesh/mesh.h"
#include "geometry/numbers/predicates.h"

namespace sightline::inline geometry {

struct ConvexFacet {
  const PolygonMesh& mesh;
  FacetId id;
  std::span<const VertexId> corners;  // where facets are compared: welded, so that equal positions have equal ids

  [[nodiscard]] std::size_t size() const { return corners.size(); }
  [[nodiscard]] const Point3& position(std::size_t corner) const { return mesh.position(corners[corner]); }
  [[nodiscard]] std::size_t next(std::size_t corner) const { return corner + 1 == size() ? 0 : corner + 1; }
  [[nodiscard]] std::span<const MeshEdgeId> edges() const { return mesh.edges_of(id); }
};

// A plane is three corners in the facet's order that do not lie on one line.
struct FacetPlane {
  Point3 a = Point3::Zero();
  Point3 b = Point3::Zero();
  Point3 c = Point3::Zero();
};

[[nodiscard]] FacetPlane plane_of(const ConvexFacet& facet);

// Returns orient3d(a, b, c, p): +1 where p sees the facet counter-clockwise.
[[nodiscard]] Sign side_of(const FacetPlane& plane, const Point3& p);

// Returns orient2d(a, b, p): +1 where p is to the left of the line from a to b.
[[nodiscard]] Sign side_of_line(const Point2& a, const Point2& b, const Point2& p);

// Returns an axis that is not among the plane's directions: projecting along it keeps the facet's shape.
[[nodiscard]] int projection_axis(const FacetPlane& plane);

// Returns the facet's orientation when projected along an axis: 0 where it degenerates.
[[nodiscard]] Sign orientation_in(const FacetPlane& plane, int axis);

enum class Place { outside, boundary, inside };

// Tells where p, a point of the facet's plane, lies; `axis` is the facet's projection axis.
[[nodiscard]] Place place_of_point(const ConvexFacet& facet, int axis, const Point3& p);

// Tells where the line through p and q, which is not in the facet's plane, meets that plane.
[[nodiscard]] Place place_of_line(const ConvexFacet& facet, const Point3& p, const HomogeneousPoint& q);

}  // namespace sightline::inline geometry
