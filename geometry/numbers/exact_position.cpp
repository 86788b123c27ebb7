#include "geometry/numbers/exact_position.h"

#include <array>

namespace sightline::inline geometry {
namespace {

BigInteger common_divisor(const ExactVector& v, const BigInteger& other) {
  return gcd(gcd(v.x(), v.y()), gcd(v.z(), other));
}

ExactVector quotient(const ExactVector& v, const BigInteger& divisor) {
  return {v.x() / divisor, v.y() / divisor, v.z() / divisor};
}

ExactPosition in_lowest_terms(ExactPosition p) {
  BigInteger divisor = common_divisor(p.xyz, p.w);
  if (p.w < 0) divisor = -divisor;
  if (divisor == 1) return p;
  return {quotient(p.xyz, divisor), p.w / divisor};
}

// Returns q - p, up to the positive factor p.w * q.w.
ExactVector difference(const ExactPosition& p, const ExactPosition& q) { return p.w * q.xyz - q.w * p.xyz; }

// Returns the plane through p with this normal.
ExactPlane plane_with_normal(const ExactPosition& p, const ExactVector& normal) {
  const ExactPlane plane{p.w * normal, -dot(normal, p.xyz)};
  const BigInteger divisor = common_divisor(plane.normal, plane.offset);
  return divisor > 1 ? ExactPlane{quotient(plane.normal, divisor), plane.offset / divisor} : plane;
}

ExactVector integers(const Vector3& v) {
  const std::array values{v.x(), v.y(), v.z()};
  const auto scaled_values = scaled<BigInteger>(values, exponent_range(values).lowest);
  return {scaled_values[0], scaled_values[1], scaled_values[2]};
}

}  // namespace

BigInteger dot(const ExactVector& u, const ExactVector& v) { return u.x() * v.x() + u.y() * v.y() + u.z() * v.z(); }

ExactVector cross(const ExactVector& u, const ExactVector& v) {
  return {u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x()};
}

Point3 ExactPosition::rounded() const {
  return {rounded_quotient(xyz.x(), w), rounded_quotient(xyz.y(), w), rounded_quotient(xyz.z(), w)};
}

ExactPosition exact_position(const Point3& p) {
  const std::array values{p.x(), p.y(), p.z(), 1.0};
  const auto scaled_values = scaled<BigInteger>(values, exponent_range(values).lowest);
  return in_lowest_terms({{scaled_values[0], scaled_values[1], scaled_values[2]}, scaled_values[3]});
}

Sign lexicographic_order(const ExactPosition& a, const ExactPosition& b) {
  const ExactVector way = difference(b, a);
  for (const BigInteger& coordinate : way) {
    if (coordinate != 0) return sign_of(coordinate);
  }
  return 0;
}

bool collinear(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  const ExactVector normal = cross(difference(a, b), difference(a, c));
  return normal.x() == 0 && normal.y() == 0 && normal.z() == 0;
}

Sign orientation_without(int axis, const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  return sign_of(cross(difference(a, b), difference(a, c))[axis]);
}

ExactPlane plane_through(const ExactPosition& p, const ExactPosition& q, const ExactPosition& r) {
  return plane_with_normal(p, cross(difference(p, q), difference(p, r)));
}

ExactPlane plane_towards(const ExactPosition& p, const ExactPosition& q, const Vector3& direction) {
  return plane_with_normal(p, cross(difference(p, q), integers(direction)));
}

ExactPosition intersection(const ExactPlane& plane, const ExactPosition& p, const ExactPosition& q) {
  const BigInteger at_p = plane.height(p);
  const BigInteger at_q = plane.height(q);
  // With the sign of at_p the factors of p and q are positive.
  return in_lowest_terms({at_p * q.xyz - at_q * p.xyz, at_p * q.w - at_q * p.w});
}

}  // namespace sightline::inline geometry
