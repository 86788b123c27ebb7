// Points and vectors of the input space, in the input's units and axes: Eigen's, with its sums, products, dot and cross.
//
// Eigen leaves a vector that nothing initialises as it finds it, and its sums and products are expressions that refer to
// their operands: so every vector gets a value where it is declared, and none is declared `auto`. Comparisons are those of
// doubles: -0.0 equals 0.0.
//
// The library is compiled without Eigen's vector instructions: every operation is IEEE double arithmetic in one order,
// whatever the compiler and the processor.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <span>

#include "geometry/numbers/export.h"

namespace sightline::inline geometry {

using Vector3 = Eigen::Vector3d;
using Point3 = Vector3;

// Not Eigen's: std::hypot neither overflows nor underflows where squares do, and bounds are proven for it.
inline double norm(const Vector3& v) { return std::hypot(v.x(), v.y(), v.z()); }

// Returns the largest of |x|, |y|, |z|.
[[nodiscard]] SIGHTLINE_EXPORT double largest_coordinate(const Vector3& v);

// Returns the same direction with its largest coordinate in [1, 2), by a power of two, so that squares and products of
// coordinates neither overflow nor vanish. Zero stays zero.
[[nodiscard]] SIGHTLINE_EXPORT Vector3 with_moderate_exponent(const Vector3& v);

// Returns the vector of length 1 in the same direction, whatever the length; zero for zero. No coordinate is -0.0.
[[nodiscard]] SIGHTLINE_EXPORT Vector3 unit(const Vector3& v);

// Returns the power of two that brings the positions' largest coordinate into [1, 2): what is computed of scaled
// positions neither overflows nor underflows. It is 1 where all are zero.
[[nodiscard]] SIGHTLINE_EXPORT double unit_scale(std::span<const Point3> positions);

}  // namespace sightline::inline geometry
