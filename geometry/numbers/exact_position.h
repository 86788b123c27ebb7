// Points and planes of space, exact: what cutting computes.
//
// A position is xyz / w in integers of any size, in lowest terms with w > 0: equal points have equal numbers. A plane is
// a form, normal . xyz + offset w, that is positive on its front side. Both come from finite doubles.
// Complexity: the numbers of a point that lies in three planes of the input have about 10 times the bits that the
// input's coordinates have as integers over a common power of two; a greatest common divisor after each construction
// keeps them there.
#pragma once

#include "geometry/numbers/exact_integer.h"
#include "geometry/numbers/export.h"
#include "geometry/numbers/vector3.h"

namespace sightline::inline geometry {

using ExactVector = Eigen::Matrix<BigInteger, 3, 1>;

// Not Eigen's, which evaluate a Boost number's expressions after the numbers in them are gone.
[[nodiscard]] SIGHTLINE_EXPORT BigInteger dot(const ExactVector& u, const ExactVector& v);
[[nodiscard]] SIGHTLINE_EXPORT ExactVector cross(const ExactVector& u, const ExactVector& v);

struct ExactPosition {
  ExactVector xyz;
  BigInteger w;
  friend bool operator==(const ExactPosition&, const ExactPosition&) = default;

  // Returns the position with each coordinate rounded once.
  [[nodiscard]] SIGHTLINE_EXPORT Point3 rounded() const;
};

[[nodiscard]] SIGHTLINE_EXPORT ExactPosition exact_position(const Point3& p);

// Compares x first, then y, then z: along a line that is one direction.
[[nodiscard]] SIGHTLINE_EXPORT Sign lexicographic_order(const ExactPosition& a, const ExactPosition& b);

[[nodiscard]] SIGHTLINE_EXPORT bool collinear(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c);

// Returns orient2d of the positions without one coordinate (drop_axis in predicates.h).
[[nodiscard]] SIGHTLINE_EXPORT Sign orientation_without(int axis, const ExactPosition& a, const ExactPosition& b,
                                                        const ExactPosition& c);

struct ExactPlane {
  ExactVector normal;
  BigInteger offset;

  // Returns, up to a positive factor, the height of p over the plane: it is > 0 where the points
  // that it was made of are seen counter-clockwise from p.
  [[nodiscard]] BigInteger height(const ExactPosition& p) const { return dot(normal, p.xyz) + offset * p.w; }
  [[nodiscard]] Sign side(const ExactPosition& p) const { return sign_of(height(p)); }
  [[nodiscard]] ExactPlane turned() const { return {-normal, -offset}; }
};

// The first is the plane of three points that are not on one line, the second that of two points and a direction that
// is not theirs; what is in front has orient3d(p, q, r, .) > 0, for the direction as for a point far away.
[[nodiscard]] SIGHTLINE_EXPORT ExactPlane plane_through(const ExactPosition& p, const ExactPosition& q,
                                                        const ExactPosition& r);
[[nodiscard]] SIGHTLINE_EXPORT ExactPlane plane_towards(const ExactPosition& p, const ExactPosition& q,
                                                        const Vector3& direction);

// Returns where the line from p to q meets the plane. Precondition: they lie strictly on different sides of it.
[[nodiscard]] SIGHTLINE_EXPORT ExactPosition intersection(const ExactPlane& plane, const ExactPosition& p,
                                                          const ExactPosition& q);

}  // namespace sightline::inline geometry
