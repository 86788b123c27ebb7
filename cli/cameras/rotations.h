// Rotations as files write them.
//
// In:  a quaternion (w, x, y, z), Hamilton's, of any length but zero; or a rotation vector, whose direction is the axis and whose
//      length the angle in radians (Rodrigues). Out: the matrix, to a few units in the last place; exactly where the entries
//      are doubles and so are the products, as of (1, 0, 0, 0), (2, 1, 0, 0), and the vector of zeros.
#pragma once

#include <array>

#include "geometry/projection/camera.h"

namespace sightline::cli {

// Precondition: not all zero.
[[nodiscard]] Matrix3 rotation_of_quaternion(const std::array<double, 4>& wxyz);

[[nodiscard]] Matrix3 rotation_of_vector(const Vector3& turn);

}  // namespace sightline::cli
