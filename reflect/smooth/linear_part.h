// The linear part is what of a triangle of the image lies where functions, known at its corners and linear between them, are not
// negative.
//
// In:  a triangle, its corners grid points in the window; per function its values at the corners.
// Out: a convex polygon on the grid that has the wanted part in common with the triangle, its corners rounded once; it
//      reaches beyond the triangle, by the triangle's size at most, so that rounding moves no border along the
//      triangle's own sides. Empty where the part is. And whether the part is all of the triangle.
// Floating point; a value that is not finite makes the part empty.
// Complexity: O(k^2) for k functions.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <vector>

#include "reflect/regions/lit_region.h"

namespace sightline::inline reflect {

using ImageTriangle = std::array<ImagePoint, 3>;
using CornerValues = std::array<double, 3>;

struct LinearPart {
  ImagePolygon polygon;
  bool is_whole = false;
};

[[nodiscard]] LinearPart linear_part(const ImageTriangle& triangle, const std::vector<CornerValues>& functions,
                                     int grid_bits);

// A convex polygon in the triangle's own coordinates. Most have few corners.
using Barycentric = std::array<double, 3>;
using BarycentricPolygon = boost::container::small_vector<Barycentric, 12>;
[[nodiscard]] BarycentricPolygon whole_triangle();

[[nodiscard]] inline double value_at(const CornerValues& values, const Barycentric& p) {
  return values[0] * p[0] + values[1] * p[1] + values[2] * p[2];
}

[[nodiscard]] Barycentric barycentric(const ImageTriangle& triangle, const Point2& place);

// Returns what of the polygon lies where a linear function is at least a value.
[[nodiscard]] BarycentricPolygon part_above(const BarycentricPolygon& polygon, const CornerValues& values,
                                            double least);

// Returns the polygon's share of the triangle.
[[nodiscard]] double share_of(const BarycentricPolygon& polygon);

}  // namespace sightline::inline reflect
