#include "geometry/projection/seen_orientation.h"

#include <array>

#include "geometry/numbers/bounded.h"
#include "geometry/projection/camera_forms.h"

namespace sightline::inline geometry {
namespace {

// The rows are those of the camera, whatever the length of its image is.
template <class Scalar, class Vector>
Scalar image_area(const Vector& right, const Vector& up, const Vector& b, const Vector& c) {
  using Forms = CameraForms<Scalar>;
  return Forms::value(right, b) * Forms::value(up, c) - Forms::value(up, b) * Forms::value(right, c);
}

}  // namespace

namespace seen_orientation_tiers {

std::optional<Sign> filtered(const Camera& camera, const Point3& a, const Point3& b, const Point3& c) {
  const BoundedVector from_a = bounded(a);
  return certain_sign(image_area<Bounded, BoundedVector>(bounded(camera.right), bounded(camera.up), bounded(b) - from_a,
                                                         bounded(c) - from_a));
}

Sign exact(const Camera& camera, const Point3& a, const Point3& b, const Point3& c) {
  const int exponent = common_exponent(camera, std::array{a, b, c});
  const CameraForms<BigInteger> forms = integer_forms(camera, exponent);
  using Vector = CameraForms<BigInteger>::Vector;
  const auto integers = [exponent](const Point3& p) -> Vector {
    return p.unaryExpr([exponent](double value) { return scaled<BigInteger>(value, exponent); });
  };
  const Vector from_a = integers(a);
  return sign_of(image_area<BigInteger, Vector>(forms.right, forms.up, integers(b) - from_a, integers(c) - from_a));
}

}  // namespace seen_orientation_tiers

Sign seen_orientation(const Camera& camera, const Point3& a, const Point3& b, const Point3& c,
                      predicates::Counts* counts) {
  if (camera.eye.w != 0) return orient3d(a, b, c, camera.eye, counts);
  const auto certain = seen_orientation_tiers::filtered(camera, a, b, c);
  if (counts != nullptr) {
    ++counts->calls;
    counts->filtered += certain ? 1 : 0;
  }
  return certain ? *certain : seen_orientation_tiers::exact(camera, a, b, c);
}

}  // namespace sightline::inline geometry
