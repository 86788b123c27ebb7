// Certified numbers: doubles known up to a radius, by which a cheap test can prove its answer.
//
// Holds: |true value - value| <= radius, for sums, differences, products and quotients of numbers for which it holds. Where
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
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "geometry/numbers/exact_integer.h"
#include "geometry/numbers/rounding.h"
#include "geometry/numbers/vector3.h"

namespace sightline::inline geometry {

struct Bounded {
  double value = 0;
  double radius = 0;

  constexpr Bounded() = default;
  // Exactly this number.
  constexpr Bounded(double exact) : value(exact) {}
  constexpr Bounded(double middle, double reach) : value(middle), radius(reach) {}

  [[nodiscard]] static constexpr double widened(double radius) {
    constexpr double factor = 1 + 0x1p-50;
    static_assert(factor * (1 - 5 * unit_roundoff) > 1);
    return radius * factor + 0x1p-1070;
  }
  // Proven. Gradual underflow gives a sum its true sign.
  [[nodiscard]] bool is_negative() const { return value + radius < 0; }
  [[nodiscard]] bool is_positive() const { return value - radius > 0; }

  friend Bounded operator-(const Bounded& a) { return {-a.value, a.radius}; }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const double m = a.value + b.value;
    return {m, widened(a.radius + b.radius + 0x1p-52 * std::abs(m))};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const double m = a.value * b.value;
    return {m,
            widened((std::abs(a.value) + a.radius) * b.radius + std::abs(b.value) * a.radius + 0x1p-52 * std::abs(m))};
  }
  // With q = fl(a / b), |A / B - a / b| <= (ra + |a / b| rb) / (|b| - rb). Nothing is known where b may be zero.
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    if (!b.is_positive() && !b.is_negative()) return {0, std::numeric_limits<double>::infinity()};
    const double q = a.value / b.value;
    const double largest = std::abs(q) + 0x1p-1074;  // where q is denormal
    const double through = widened(a.radius + largest * b.radius) / (std::abs(b.value) - b.radius);
    return {q, widened(through + 0x1p-51 * std::abs(q))};
  }
  Bounded& operator+=(const Bounded& b) { return *this = *this + b; }
  Bounded& operator-=(const Bounded& b) { return *this = *this - b; }
  Bounded& operator*=(const Bounded& b) { return *this = *this * b; }
  Bounded& operator/=(const Bounded& b) { return *this = *this / b; }
};

}  // namespace sightline::inline geometry

// As Eigen is to see it: neither an integer nor free to copy.
template <>
struct Eigen::NumTraits<sightline::Bounded> : Eigen::GenericNumTraits<sightline::Bounded> {
  using Real = sightline::Bounded;
  using NonInteger = sightline::Bounded;
  using Nested = sightline::Bounded;
  using Literal = sightline::Bounded;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 6,
    MulCost = 10
  };
};

namespace sightline::inline geometry {

// Zero only where the number is exactly that; nothing where it is not certain.
[[nodiscard]] inline std::optional<Sign> certain_sign(const Bounded& b) {
  if (b.is_positive()) return 1;
  if (b.is_negative()) return -1;
  if (b.value == 0 && b.radius == 0) return 0;
  return std::nullopt;
}

// Holds all of [low, high].
[[nodiscard]] inline Bounded bounded_around(double low, double high) {
  const double middle = 0.5 * low + 0.5 * high;
  return {middle, Bounded::widened(std::fmax(high - middle, middle - low))};
}

// The integer nearest to 2^bits b, ties away from zero, if all that b may be has the same. The sum with 1/2 has twice the
// radius that its rounding needs: the ends' own rounding is no larger.
[[nodiscard]] inline std::optional<std::int64_t> certain_integer(const Bounded& b, int bits) {
  const Bounded size{std::ldexp(std::abs(b.value), bits), std::ldexp(b.radius, bits)};
  const Bounded shifted = size + 0.5;
  const double low = std::floor(shifted.value - Bounded::widened(shifted.radius));
  const double high = std::floor(shifted.value + Bounded::widened(shifted.radius));
  if (!(low == high)) return std::nullopt;
  const auto rounded = static_cast<std::int64_t>(low);
  return b.value < 0 ? -rounded : rounded;
}

using BoundedVector = Eigen::Matrix<Bounded, 3, 1>;

// Exactly this vector.
[[nodiscard]] inline BoundedVector bounded(const Vector3& v) { return v.cast<Bounded>(); }

}  // namespace sightline::inline geometry
