// Arithmetic on balls: numbers known up to a radius, by which a cheap test can prove its answer.
//
// Holds: |true value - middle| <= radius, for sums, differences, products and quotients of balls for which it holds. Where
// nothing is known (an overflow, infinity minus infinity) the radius is infinite or one of both is no number, and no
// comparison holds.
//
// Derivation, with u = 2^-53 and every operation rounded to nearest. A sum m = fl(a + b) is off by at most u |m|, a product
// by at most u |m| + 2^-1075, beside what the radii let through: ra + rb, and |a| rb + |b| ra + ra rb. Twice u |m| is
// written 2^-52 |m|. The radius is itself computed from numbers that are not negative, with at most five roundings, the
// last by `widened`: its sum can come out too small by a factor of (1 - u)^5, and by 2^-1075 for each of three products.
// Widening by 1 + 8 u and adding 2^-1070 covers both.
// Rejected: intervals with ends moved outwards. Four products and their minimum, for each product, took most of the time
// of a pyramid.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/mesh/box_hierarchy.h"
#include "geometry/numbers/vector3.h"

namespace sightline::inline reflect {

struct Ball {
  double middle = 0;
  double radius = 0;

  [[nodiscard]] static constexpr double widened(double radius) {
    constexpr double factor = 1 + 0x1p-50;
    static_assert(factor * (1 - 5 * 0x1p-53) > 1);
    return radius * factor + 0x1p-1070;
  }
  // Proven. Gradual underflow gives a sum its true sign.
  [[nodiscard]] bool is_negative() const { return middle + radius < 0; }
  [[nodiscard]] bool is_positive() const { return middle - radius > 0; }

  friend Ball operator-(const Ball& a) { return {-a.middle, a.radius}; }
  friend Ball operator+(const Ball& a, const Ball& b) {
    const double m = a.middle + b.middle;
    return {m, widened(a.radius + b.radius + 0x1p-52 * std::abs(m))};
  }
  friend Ball operator-(const Ball& a, const Ball& b) { return a + -b; }
  friend Ball operator*(const Ball& a, const Ball& b) {
    const double m = a.middle * b.middle;
    return {
        m, widened((std::abs(a.middle) + a.radius) * b.radius + std::abs(b.middle) * a.radius + 0x1p-52 * std::abs(m))};
  }
  // With q = fl(a / b), |A / B - a / b| <= (ra + |a / b| rb) / (|b| - rb). Nothing is known where b may be zero.
  friend Ball operator/(const Ball& a, const Ball& b) {
    if (!b.is_positive() && !b.is_negative()) return {0, std::numeric_limits<double>::infinity()};
    const double q = a.middle / b.middle;
    const double largest = std::abs(q) + 0x1p-1074;  // where q is denormal
    const double through = widened(a.radius + largest * b.radius) / (std::abs(b.middle) - b.radius);
    return {q, widened(through + 0x1p-51 * std::abs(q))};
  }
};

[[nodiscard]] inline Ball exactly(double x) { return {x, 0}; }

// Holds all of [low, high].
[[nodiscard]] inline Ball ball_around(double low, double high) {
  const double middle = 0.5 * low + 0.5 * high;
  return {middle, Ball::widened(std::fmax(high - middle, middle - low))};
}

using BallVector = std::array<Ball, 3>;

[[nodiscard]] inline BallVector exactly(const Vector3& v) { return {exactly(v.x()), exactly(v.y()), exactly(v.z())}; }
[[nodiscard]] inline BallVector ball_around(const Box& box) {
  return {ball_around(box.low.x(), box.high.x()), ball_around(box.low.y(), box.high.y()),
          ball_around(box.low.z(), box.high.z())};
}
[[nodiscard]] inline Ball dot(const BallVector& u, const BallVector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
[[nodiscard]] inline BallVector operator-(const BallVector& u, const BallVector& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}
[[nodiscard]] inline BallVector operator*(const Ball& s, const BallVector& v) { return {s * v[0], s * v[1], s * v[2]}; }
[[nodiscard]] inline BallVector cross(const BallVector& u, const BallVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// normal . v + constant.
struct BallForm {
  BallVector normal;
  Ball constant;

  [[nodiscard]] Ball at(const BallVector& v) const { return dot(normal, v) + constant; }
  [[nodiscard]] bool is_positive_at(std::span<const Point3> points) const {
    return std::all_of(points.begin(), points.end(), [this](const Point3& p) { return at(exactly(p)).is_positive(); });
  }
  friend BallForm operator-(const BallForm& f) { return {{-f.normal[0], -f.normal[1], -f.normal[2]}, -f.constant}; }
  friend BallForm operator-(const BallForm& f, const BallForm& g) {
    return {f.normal - g.normal, f.constant - g.constant};
  }
  friend BallForm operator*(const Ball& s, const BallForm& f) { return {s * f.normal, s * f.constant}; }
};

}  // namespace sightline::inline reflect
