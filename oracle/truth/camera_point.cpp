#include "oracle/truth/camera_point.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

namespace sightline::oracle::image {
namespace {

// A double other than zero is an odd whole number times a power of two.
struct Binary {
  std::int64_t odd;
  int exponent;
};

Binary binary(double value) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mantissa >> zeros, exponent - 53 + zeros};
}

// Returns the exponent of the largest power of two that all numbers are multiples of; 0 where all are zero.
int common_unit(const std::vector<Vector3>& vectors) {
  std::optional<int> unit;
  for (const Vector3& v : vectors) {
    for (const double value : {v.x(), v.y(), v.z()}) {
      if (value != 0) unit = std::min(unit.value_or(INT32_MAX), binary(value).exponent);
    }
  }
  return unit.value_or(0);
}

Integer power_of_two(int exponent) { return pow(Integer(2), static_cast<unsigned>(exponent)); }

Integer whole(double value, int unit) {
  if (value == 0) return 0;
  const Binary b = binary(value);
  return b.odd * power_of_two(b.exponent - unit);
}

WholeVector whole(const Vector3& v, int unit) { return {whole(v.x(), unit), whole(v.y(), unit), whole(v.z(), unit)}; }

Integer dot(const WholeVector& u, const WholeVector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

int handedness_of(const WholeVector& right, const WholeVector& up, const WholeVector& forward) {
  const WholeVector across{right.y * up.z - right.z * up.y, right.z * up.x - right.x * up.z,
                           right.x * up.y - right.y * up.x};
  return dot(across, forward) < 0 ? 1 : -1;
}

}  // namespace

ExactCamera exact_camera(const PolygonMesh& mesh, const Camera& camera) {
  std::vector<Vector3> positions = mesh.vertices;
  positions.push_back(camera.origin);
  const int row_unit = common_unit({camera.right, camera.up, camera.forward});
  ExactCamera result;
  result.perspective = camera.projection == Projection::perspective;
  result.unit = std::min(common_unit(positions), -row_unit);  // so that 1 is a whole number, too
  result.one = power_of_two(-row_unit - result.unit);
  result.right = whole(camera.right, row_unit);
  result.up = whole(camera.up, row_unit);
  result.forward = whole(camera.forward, row_unit);
  result.origin = whole(camera.origin, result.unit);
  result.handedness = handedness_of(result.right, result.up, result.forward);
  return result;
}

CameraPoint camera_point(const ExactCamera& camera, const Point3& v) {
  const WholeVector p = whole(v, camera.unit);
  const WholeVector offset{p.x - camera.origin.x, p.y - camera.origin.y, p.z - camera.origin.z};
  const Integer depth = dot(camera.forward, offset);
  const Integer x = dot(camera.right, offset);
  const Integer y = dot(camera.up, offset);
  if (camera.perspective) return {{x, y, depth}, camera.one};
  return {{x, y, camera.one}, -depth};
}

}  // namespace sightline::oracle::image
