#include "geometry/projection/unfiltered.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "geometry/projection/camera_forms.h"

namespace sightline::inline geometry::unfiltered {
namespace {

static_assert(FLT_EVAL_METHOD == 0, "float and double must be evaluated in their own type");

template <class Real>
using RealVector = Eigen::Matrix<Real, 3, 1>;

template <class Real>
RealVector<Real> rounded_vector(const Vector3& v) {
  return v.unaryExpr([](double value) { return rounded<Real>(value); });
}

template <class Real>
Sign orient3d_in(const Point3& a, const Point3& b, const Point3& c, const HomogeneousPoint& d) {
  const RealVector<Real> origin = rounded_vector<Real>(a);
  const RealVector<Real> last = rounded_vector<Real>(d.xyz);
  const RealVector<Real> u = rounded_vector<Real>(b) - origin;
  const RealVector<Real> v = rounded_vector<Real>(c) - origin;
  const RealVector<Real> w = d.w == 0 ? last : RealVector<Real>(last - origin);
  const RealVector<Real> normal = u.cross(v);
  return sign_of((normal.x() * w.x() + normal.y() * w.y()) + normal.z() * w.z());
}

template <class Real>
std::int64_t grid_coordinate(Real numerator, Real denominator, int grid_bits) {
  const auto half_window = static_cast<Real>(std::int64_t{1} << static_cast<unsigned>(grid_bits));
  const Real place = std::round(numerator / denominator * half_window);
  return static_cast<std::int64_t>(std::clamp(place, -half_window, half_window));
}

template <class Real>
ImagePoint image_point_in(const Point3& vertex, const Camera& camera, const Precision& precision) {
  const CameraForms<Real> forms(camera, [](double value) { return rounded<Real>(value); });
  const auto [x, y, w, depth] = forms.at(rounded_vector<Real>(vertex));
  if (std::isnan(x / w) || std::isnan(y / w)) {
    throw ArithmeticError(to_string(precision.arithmetic), "a vertex has no place in the image");
  }
  return {grid_coordinate(x, w, precision.grid_bits), grid_coordinate(y, w, precision.grid_bits)};
}

}  // namespace

Sign orient3d(Arithmetic arithmetic, const Point3& a, const Point3& b, const Point3& c, const HomogeneousPoint& d) {
  return arithmetic == Arithmetic::single_precision ? orient3d_in<float>(a, b, c, d) : orient3d_in<double>(a, b, c, d);
}

ImagePoint image_point(const Precision& precision, const Point3& vertex, const Camera& camera) {
  return precision.arithmetic == Arithmetic::single_precision ? image_point_in<float>(vertex, camera, precision)
                                                              : image_point_in<double>(vertex, camera, precision);
}

}  // namespace sightline::inline geometry::unfiltered
