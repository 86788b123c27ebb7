// Projection and predicates by plain evaluation in float or double: no filter, no error bound, nothing exact behind it.
//
// In:  finite doubles of any size, rounded to the type first. Out: what the formula gives in it, right or wrong.
// Holds: every call ends, and no value is out of range whatever over- or underflows: a sign of what is no number is 0,
//      a place is in the window.
// Complexity: O(1).
// Errors: ArithmeticError from image_point, where a vertex has no place.
#pragma once

#include <limits>

#include "geometry/numbers/arithmetic.h"
#include "geometry/projection/camera.h"

namespace sightline::inline geometry::unfiltered {

// Returns the number nearest to value; it is infinite beyond the type's range.
template <class Real>
[[nodiscard]] constexpr Real rounded(double value) {
  constexpr auto infinity = std::numeric_limits<Real>::infinity();
  if (value > std::numeric_limits<Real>::max()) return infinity;
  if (value < std::numeric_limits<Real>::lowest()) return -infinity;
  return static_cast<Real>(value);
}

// These are the predicates of predicates.h. Precondition of all: the arithmetic is not exact.
[[nodiscard]] Sign orient3d(Arithmetic arithmetic, const Point3& a, const Point3& b, const Point3& c,
                            const HomogeneousPoint& d);

// Returns the grid point of a vertex in the view volume: its image coordinates are computed in the type, rounded to the
// grid, and held within the window.
[[nodiscard]] ImagePoint image_point(const Precision& precision, const Point3& vertex, const Camera& camera);

}  // namespace sightline::inline geometry::unfiltered
