#include "geometry/mesh/convex_facet.h"

#include <cmath>

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline geometry {
namespace {

Sign compare(double a, double b) { return (a > b ? 1 : 0) - (a < b ? 1 : 0); }

double coordinate(const Point3& p, int axis) { return axis == 0 ? p.x() : (axis == 1 ? p.y() : p.z()); }

bool is_perpendicular_to(const FacetPlane& plane, int axis) {
  const double level = coordinate(plane.a, axis);
  return level == coordinate(plane.b, axis) && level == coordinate(plane.c, axis);
}

// Tells which axis the normal is closest to; this is only a first guess, since the normal is rounded.
int dominant_axis(const FacetPlane& plane) {
  const Vector3 normal = (plane.b - plane.a).cross(plane.c - plane.a);
  const double x = std::fabs(normal.x());
  const double y = std::fabs(normal.y());
  const double z = std::fabs(normal.z());
  if (x >= y && x >= z) return 0;
  return y >= z ? 1 : 2;
}

// This collects the sides of a convex polygon's edges on which a place of its plane was seen, whichever way the polygon
// turns. A place outside is strictly outside of one edge and strictly inside of another.
class SeenSides {
 public:
  void add(Sign side) {
    negative_ |= side < 0;
    zero_ |= side == 0;
    positive_ |= side > 0;
  }
  [[nodiscard]] bool outside() const { return negative_ && positive_; }
  [[nodiscard]] Place place() const {
    if (outside()) return Place::outside;
    return zero_ ? Place::boundary : Place::inside;
  }

 private:
  bool negative_ = false;
  bool zero_ = false;
  bool positive_ = false;
};

}  // namespace

FacetPlane plane_of(const ConvexFacet& facet) {
  const auto [a, b, c] = plane_corners(facet.mesh, facet.mesh.corners(facet.id));
  return {facet.mesh.position(a), facet.mesh.position(b), facet.mesh.position(c)};
}

Sign side_of(const FacetPlane& plane, const Point3& p) {
  for (const int axis : {0, 1, 2}) {
    if (!is_perpendicular_to(plane, axis)) continue;
    const Sign above = compare(coordinate(p, axis), coordinate(plane.a, axis));
    return above == 0 ? 0 : above * orientation_in(plane, axis);
  }
  return orient3d(plane.a, plane.b, plane.c, p);
}

// The determinant is a difference of two products: their signs decide unless both are positive or both negative.
Sign side_of_line(const Point2& a, const Point2& b, const Point2& p) {
  const Sign first = compare(b.x, a.x) * compare(p.y, a.y);
  const Sign second = compare(b.y, a.y) * compare(p.x, a.x);
  if (first * second > 0) return orient2d(a, b, p);
  return compare(first, second);
}

int projection_axis(const FacetPlane& plane) {
  int axis = dominant_axis(plane);
  while (orientation_in(plane, axis) == 0) axis = (axis + 1) % 3;
  return axis;
}

Sign orientation_in(const FacetPlane& plane, int axis) {
  return side_of_line(drop_axis(plane.a, axis), drop_axis(plane.b, axis), drop_axis(plane.c, axis));
}

Place place_of_point(const ConvexFacet& facet, int axis, const Point3& p) {
  SeenSides seen;
  for (std::size_t i = 0; i < facet.size() && !seen.outside(); ++i) {
    const Point2 from = drop_axis(facet.position(i), axis);
    const Point2 to = drop_axis(facet.position(facet.next(i)), axis);
    seen.add(side_of_line(from, to, drop_axis(p, axis)));
  }
  return seen.place();
}

Place place_of_line(const ConvexFacet& facet, const Point3& p, const HomogeneousPoint& q) {
  SeenSides seen;
  for (std::size_t i = 0; i < facet.size() && !seen.outside(); ++i) {
    seen.add(orient3d(facet.position(i), facet.position(facet.next(i)), p, q));
  }
  return seen.place();
}

}  // namespace sightline::inline geometry
