#include "cli/cameras/rotations.h"

#include <algorithm>
#include <cmath>

namespace sightline::cli {

// Divided by a power of two first, so that no square overflows or vanishes.
Matrix3 rotation_of_quaternion(const std::array<double, 4>& wxyz) {
  double largest = 0;
  for (const double q : wxyz) largest = std::max(largest, std::fabs(q));
  const int exponent = -std::ilogb(largest);
  const double w = std::scalbn(wxyz[0], exponent);
  const double x = std::scalbn(wxyz[1], exponent);
  const double y = std::scalbn(wxyz[2], exponent);
  const double z = std::scalbn(wxyz[3], exponent);
  const double square = w * w + x * x + y * y + z * z;
  Matrix3 r;
  r << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return (r / square).array() + 0.0;
}

Matrix3 rotation_of_vector(const Vector3& turn) {
  const double angle = norm(turn);
  const Vector3 axis = unit(turn);
  Matrix3 cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  const double half_sine = std::sin(angle / 2);
  return Matrix3::Identity() + std::sin(angle) * cross + 2 * half_sine * half_sine * (cross * cross);
}

}  // namespace sightline::cli
