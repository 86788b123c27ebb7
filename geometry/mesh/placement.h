// Where a mesh stands in a scene: a matrix, a length, and which axis of the file points up.
//
// In:  positions in the axes and units of a file.
// Out: positions in the scene. First up_axis turns the file's upwards axis to y, then lengths are multiplied by `length`, then
//      the matrix maps x, y, z, 1 to x, y, z.
// Holds: each coordinate is computed exactly and rounded once, to the nearest double (ties to even). A coordinate that is
//      only passed on keeps its bits, the sign of a zero too; so a placement that changes nothing leaves all bits alone.
// Complexity: O(1) per position: in double words where these prove what it rounds to, else in integers.
// Errors: PlacementError for a matrix that is singular (exactly), and for coordinates beyond the range of double.
#pragma once

#include <cstdint>

#include "geometry/mesh/mesh.h"
#include "geometry/numbers/errors.h"
#include "geometry/numbers/exact_integer.h"

namespace sightline::inline geometry {

class PlacementError : public Error {
  using Error::Error;
};

enum class UpAxis : std::uint8_t { x, y, z };

// A length as a ratio, exact also where it is a decimal: a millimetre is 1 / 1000 metres. Both are above zero.
struct LengthRatio {
  double numerator = 1;
  double denominator = 1;
};

struct Placement {
  Eigen::Matrix<double, 3, 4, Eigen::DontAlign> matrix = Eigen::Matrix<double, 3, 4, Eigen::DontAlign>::Identity();
  LengthRatio length{};
  UpAxis up_axis = UpAxis::y;

  [[nodiscard]] bool changes_nothing() const;
  // The sign of the determinant: -1 for a mirror image, 0 where space is flattened.
  [[nodiscard]] Sign orientation() const;
};

[[nodiscard]] Point3 placed(const Placement& placement, const Point3& p);

// Places vertices and normals. In a mirror image the fronts of faces would be where their backs were; so faces get the reverse
// order of corners, and what was in front stays in front. `corner_normals` is parallel to faces.corners, or empty; normals are
// directions, of any length, and rounded.
void place(const Placement& placement, std::vector<Point3>& vertices, PolygonList& faces,
           std::vector<Vector3>& corner_normals);

}  // namespace sightline::inline geometry
