// The linear part is what of a triangle of the image lies where functions, known at its corners and linear between them, are not negative.
//
// In:  a right triangle with two sides along the axes, its corners grid points; per function its values at the corners.
// Out: a convex polygon on the grid that has the wanted part in common with the triangle, its corners rounded once; it
//      reaches beyond the triangle, by the triangle's size at most, so that rounding moves no border along the
//      triangle's own sides. Empty where the part is, or where it does not reach into the domain: what has values above
//      1 of other functions. And whether the part is all of the triangle.
// Floating point; a value that is not finite makes the part empty.
// Complexity: O(k^2) for k functions.
#pragma once

#include <array>
#include <vector>

#include "reflect/regions/lit_region.h"

namespace sightline::inline reflect {

// The corners are the right angle, then its neighbours along x and along y.
using RightTriangle = std::array<ImagePoint, 3>;
using CornerValues = std::array<double, 3>;

struct LinearPart {
  ImagePolygon polygon;
  bool is_whole = false;
};

[[nodiscard]] LinearPart linear_part(const RightTriangle& triangle, const std::vector<CornerValues>& functions,
                                     const std::vector<CornerValues>& domain, int grid_bits);

}  // namespace sightline::inline reflect
