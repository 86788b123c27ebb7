// Points and vectors of the input space, in the input's units and axes.
//
// The operations are plain IEEE double arithmetic in a fixed order, so that every compiler gives the same bits.
#pragma once

#include <cmath>
#include <span>

#include "geometry/numbers/export.h"

namespace sightline::inline geometry {

struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  // -0.0 equals 0.0.
  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

using Point3 = Vector3;

constexpr Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vector3 operator*(double s, const Vector3& v) { return {s * v.x, s * v.y, s * v.z}; }

constexpr double dot(const Vector3& a, const Vector3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }

constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double norm(const Vector3& v) { return std::hypot(v.x, v.y, v.z); }

// The largest of |x|, |y|, |z|.
[[nodiscard]] SIGHTLINE_EXPORT double largest_coordinate(const Vector3& v);

// The same direction with its largest coordinate in [1, 2), by a power of two, so that squares and products of
// coordinates neither overflow nor vanish. Zero stays zero.
[[nodiscard]] SIGHTLINE_EXPORT Vector3 with_moderate_exponent(const Vector3& v);

// The vector of length 1 in the same direction, whatever the length; zero for zero. No coordinate is -0.0.
[[nodiscard]] SIGHTLINE_EXPORT Vector3 unit(const Vector3& v);

// The power of two that brings the positions' largest coordinate into [1, 2): what is computed of scaled positions
// neither overflows nor underflows. 1 where all are zero.
[[nodiscard]] SIGHTLINE_EXPORT double unit_scale(std::span<const Point3> positions);

}  // namespace sightline::inline geometry
