#include "geometry/numbers/exact_position.h"

#include <array>

namespace sightline::inline geometry {
namespace {

using Triple = std::array<BigInteger, 3>;

ExactPosition in_lowest_terms(ExactPosition p) {
  BigInteger divisor = gcd(gcd(p.x, p.y), gcd(p.z, p.w));
  if (p.w < 0) divisor = -divisor;
  if (divisor == 1) return p;
  return {p.x / divisor, p.y / divisor, p.z / divisor, p.w / divisor};
}

// Returns q - p, up to the positive factor p.w * q.w.
Triple difference(const ExactPosition& p, const ExactPosition& q) {
  return {q.x * p.w - p.x * q.w, q.y * p.w - p.y * q.w, q.z * p.w - p.z * q.w};
}

Triple cross(const Triple& u, const Triple& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// Returns the plane through p with this normal.
ExactPlane plane_with_normal(const ExactPosition& p, const Triple& normal) {
  const BigInteger height = normal[0] * p.x + normal[1] * p.y + normal[2] * p.z;
  ExactPlane plane{normal[0] * p.w, normal[1] * p.w, normal[2] * p.w, -height};
  const BigInteger divisor = gcd(gcd(plane.a, plane.b), gcd(plane.c, plane.d));
  if (divisor > 1) {
    for (BigInteger* coefficient : {&plane.a, &plane.b, &plane.c, &plane.d}) *coefficient /= divisor;
  }
  return plane;
}

}  // namespace

Point3 ExactPosition::rounded() const {
  return {rounded_quotient(x, w), rounded_quotient(y, w), rounded_quotient(z, w)};
}

ExactPosition exact_position(const Point3& p) {
  const std::array values{p.x(), p.y(), p.z(), 1.0};
  const auto scaled_values = scaled<BigInteger>(values, exponent_range(values).lowest);
  return in_lowest_terms({scaled_values[0], scaled_values[1], scaled_values[2], scaled_values[3]});
}

Sign lexicographic_order(const ExactPosition& a, const ExactPosition& b) {
  for (const auto coordinate : {&ExactPosition::x, &ExactPosition::y, &ExactPosition::z}) {
    const Sign order = sign_of(BigInteger(a.*coordinate * b.w - b.*coordinate * a.w));
    if (order != 0) return order;
  }
  return 0;
}

bool collinear(const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  const Triple normal = cross(difference(a, b), difference(a, c));
  return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
}

Sign orientation_without(int axis, const ExactPosition& a, const ExactPosition& b, const ExactPosition& c) {
  return sign_of(cross(difference(a, b), difference(a, c))[static_cast<std::size_t>(axis)]);
}

ExactPlane plane_through(const ExactPosition& p, const ExactPosition& q, const ExactPosition& r) {
  return plane_with_normal(p, cross(difference(p, q), difference(p, r)));
}

ExactPlane plane_towards(const ExactPosition& p, const ExactPosition& q, const Vector3& direction) {
  const std::array values{direction.x(), direction.y(), direction.z()};
  return plane_with_normal(p, cross(difference(p, q), scaled<BigInteger>(values, exponent_range(values).lowest)));
}

ExactPosition intersection(const ExactPlane& plane, const ExactPosition& p, const ExactPosition& q) {
  const BigInteger at_p = plane.height(p);
  const BigInteger at_q = plane.height(q);
  const auto blend = [&](const BigInteger& of_p, const BigInteger& of_q) {
    return BigInteger(of_q * at_p - of_p * at_q);
  };
  // With the sign of at_p the factors of p and q are positive.
  return in_lowest_terms({blend(p.x, q.x), blend(p.y, q.y), blend(p.z, q.z), blend(p.w, q.w)});
}

}  // namespace sightline::inline geometry
