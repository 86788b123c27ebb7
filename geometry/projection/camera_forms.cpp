#include "geometry/projection/camera_forms.h"

#include <vector>

namespace sightline::inline geometry {

int common_exponent(const Camera& camera, std::span<const Point3> points) {
  std::vector<double> values{1.0};
  const auto add = [&values](const Vector3& v) { values.insert(values.end(), v.begin(), v.end()); };
  for (const Vector3& v : {camera.right, camera.up, camera.forward, camera.origin}) add(v);
  for (const Point3& p : points) add(p);
  return exponent_range(values).lowest;
}

CameraForms<BigInteger> integer_forms(const Camera& camera, int exponent) {
  return {camera, [exponent](double value) { return scaled<BigInteger>(value, exponent); }};
}

}  // namespace sightline::inline geometry
