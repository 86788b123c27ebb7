// The plane that fits a polygon whose corners are not in one plane, or are there but for rounding.
//
// In:  the corners of a polygon. Out: the plane through their mean, across the polygon's area vector (Newell's normal); its normal
// has length 1, or is zero where the area vector is. Approximate, in double. Complexity: O(k).
// Source: Sutherland, Sproull and Schumacker 1974, for Newell's normal.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/numbers/vector3.h"

namespace sightline::inline geometry {

[[nodiscard]] inline Vector3 area_vector(std::span<const Point3> corners) {
  Vector3 twice = Vector3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
    twice += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  return twice / 2;
}

struct FittedPlane {
  Point3 mean = Point3::Zero();
  Vector3 normal = Vector3::Zero();

  [[nodiscard]] double height(const Point3& p) const { return normal.dot(p - mean); }
  [[nodiscard]] Point3 foot(const Point3& p) const { return p - height(p) * normal; }
};

[[nodiscard]] inline FittedPlane fitted_plane(std::span<const Point3> corners) {
  Vector3 sum = Vector3::Zero();
  for (const Point3& corner : corners) sum += corner - corners[0];
  return {corners[0] + sum / static_cast<double>(corners.size()), unit(area_vector(corners))};
}

}  // namespace sightline::inline geometry
