#include "geometry/numbers/vector3.h"

#include <algorithm>

namespace sightline::inline geometry {

// Not Eigen's maxCoeff: what it gives where a coordinate is no number is not specified.
double largest_coordinate(const Vector3& v) { return std::max({std::fabs(v.x()), std::fabs(v.y()), std::fabs(v.z())}); }

Vector3 with_moderate_exponent(const Vector3& v) {
  const double size = largest_coordinate(v);
  if (size == 0) return Vector3::Zero();
  const int exponent = -std::ilogb(size);
  return {std::scalbn(v.x(), exponent), std::scalbn(v.y(), exponent), std::scalbn(v.z(), exponent)};
}

Vector3 unit(const Vector3& v) {
  const Vector3 moderate = with_moderate_exponent(v);
  const double length = std::sqrt(moderate.dot(moderate));
  if (length == 0) return Vector3::Zero();
  return (moderate / length).array() + 0.0;
}

double unit_scale(std::span<const Point3> positions) {
  double largest = 0;
  for (const Point3& p : positions) largest = std::max(largest, largest_coordinate(p));
  // 2^1023 is the largest power of two: what is smaller than 2^-1023 is as good as zero.
  return largest == 0 ? 1 : std::ldexp(1.0, std::min(-std::ilogb(largest), 1023));
}

}  // namespace sightline::inline geometry
