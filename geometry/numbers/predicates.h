// Exact predicates on input coordinates.
//
// In:  finite doubles of any size, denormals included.
// Out: a Sign. Every predicate has a tier in double with a proven error bound (predicates::filter, which answers
//      `nullopt` where the bound does not decide) and an exact tier in integers behind it (predicates::exact). Both
//      tiers are public so that tests can hold one against the other.
//
// orient3d(a, b, c, d)
//   Result: +1 where d lies on the side of the plane abc from which a, b, c are seen counter-clockwise (the sign of
//   ((b - a) x (c - a)) . (d - a)), -1 on the other side, 0 where the four are coplanar.
//   Symmetries: (1) swapping any two arguments flips the sign; (2) translating, or scaling by a power of two, changes
//   nothing.
// orient3d(a, b, c, eye): the same with a homogeneous last point: w = 1 a point, w = 0 a direction towards infinity.
// orient2d(a, b, c): +1 where a, b, c turn counter-clockwise. Same symmetries.
// in_circle(a, b, c, d), for a, b, c counter-clockwise: +1 where d is strictly inside their circle, 0 on it.
//   Symmetry: swapping any two arguments flips the sign.
#pragma once

#include <optional>

#include "geometry/numbers/exact_integer.h"
#include "geometry/numbers/export.h"
#include "geometry/numbers/vector3.h"

namespace sightline::inline geometry {

// With w = 1 this is a point, with w = 0 the direction towards a point at infinity. No other w occurs.
struct HomogeneousPoint {
  Vector3 xyz = Vector3::Zero();
  int w = 1;
};

struct Point2 {
  double x = 0;
  double y = 0;
  friend constexpr bool operator==(const Point2&, const Point2&) = default;
};

namespace predicates {

// The counts say what the predicates did, for the report: calls, and how many of them the filter decided.
struct Counts {
  std::uint64_t calls = 0;
  std::uint64_t filtered = 0;
};

namespace filter {
[[nodiscard]] SIGHTLINE_EXPORT std::optional<Sign> orient3d(const Point3& a, const Point3& b, const Point3& c,
                                                            const HomogeneousPoint& d);
[[nodiscard]] SIGHTLINE_EXPORT std::optional<Sign> orient2d(const Point2& a, const Point2& b, const Point2& c);
[[nodiscard]] SIGHTLINE_EXPORT std::optional<Sign> in_circle(const Point2& a, const Point2& b, const Point2& c,
                                                             const Point2& d);
}  // namespace filter

namespace exact {
[[nodiscard]] SIGHTLINE_EXPORT Sign orient3d(const Point3& a, const Point3& b, const Point3& c,
                                             const HomogeneousPoint& d);
[[nodiscard]] SIGHTLINE_EXPORT Sign orient2d(const Point2& a, const Point2& b, const Point2& c);
[[nodiscard]] SIGHTLINE_EXPORT Sign in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
}  // namespace exact

}  // namespace predicates

[[nodiscard]] SIGHTLINE_EXPORT Sign orient3d(const Point3& a, const Point3& b, const Point3& c,
                                             const HomogeneousPoint& d, predicates::Counts* counts = nullptr);
[[nodiscard]] SIGHTLINE_EXPORT Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                             predicates::Counts* counts = nullptr);
[[nodiscard]] SIGHTLINE_EXPORT Sign orient2d(const Point2& a, const Point2& b, const Point2& c);
[[nodiscard]] SIGHTLINE_EXPORT Sign in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

// Returns the point without one coordinate (0: x, 1: y, 2: z), the remaining two in cyclic order, so that a triangle
// whose normal has a positive component along `axis` stays counter-clockwise.
[[nodiscard]] inline Point2 drop_axis(const Point3& p, int axis) {
  if (axis == 0) return {p.y(), p.z()};
  if (axis == 1) return {p.z(), p.x()};
  return {p.x(), p.y()};
}

// Returns whether three points lie on one line, exactly.
[[nodiscard]] SIGHTLINE_EXPORT bool collinear(const Point3& a, const Point3& b, const Point3& c);

}  // namespace sightline::inline geometry
