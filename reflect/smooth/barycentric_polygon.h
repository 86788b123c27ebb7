// Convex polygons in the coordinates of a triangle of the image, and where functions that are linear on it are large enough.
//
// In:  a triangle, its corners grid points; a function by its values at the corners.
// Out: parts of polygons, shares of the triangle's area.
// Floating point.
// Complexity: O(k) for k corners.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>

#include "geometry/numbers/image_point.h"
#include "geometry/numbers/predicates.h"

namespace sightline::inline reflect {

using ImageTriangle = std::array<ImagePoint, 3>;
using CornerValues = std::array<double, 3>;

// Most polygons have few corners.
using Barycentric = std::array<double, 3>;
using BarycentricPolygon = boost::container::small_vector<Barycentric, 12>;
[[nodiscard]] BarycentricPolygon whole_triangle();

[[nodiscard]] inline double value_at(const CornerValues& values, const Barycentric& p) {
  return values[0] * p[0] + values[1] * p[1] + values[2] * p[2];
}

[[nodiscard]] inline Barycentric between(const Barycentric& p, const Barycentric& q, double share) {
  return {p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]), p[2] + share * (q[2] - p[2])};
}

[[nodiscard]] Barycentric barycentric(const ImageTriangle& triangle, const Point2& place);

// Returns what of the polygon lies where a linear function is at least a value.
[[nodiscard]] BarycentricPolygon part_above(const BarycentricPolygon& polygon, const CornerValues& values,
                                            double least);

// Returns the polygon's share of the triangle.
[[nodiscard]] double share_of(const BarycentricPolygon& polygon);

}  // namespace sightline::inline reflect
