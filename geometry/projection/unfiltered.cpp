#include "geometry/projection/unfiltered.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace sightline::inline geometry::unfiltered {
namespace {

static_assert(FLT_EVAL_METHOD == 0, "float and double must be evaluated in their own type");

template <class Real>
struct RealVector {
  Real x = 0;
  Real y = 0;
  Real z = 0;
};

template <class Real>
RealVector<Real> rounded_vector(const Vector3& v) {
  return {rounded<Real>(v.x()), rounded<Real>(v.y()), rounded<Real>(v.z())};
}

template <class Real>
RealVector<Real> operator-(const RealVector<Real>& a, const RealVector<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Real>
Real dot(const RealVector<Real>& a, const RealVector<Real>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <class Real>
RealVector<Real> cross(const RealVector<Real>& a, const RealVector<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
Sign orient3d_in(const Point3& a, const Point3& b, const Point3& c, const HomogeneousPoint& d) {
  const auto origin = rounded_vector<Real>(a);
  const auto last = rounded_vector<Real>(d.xyz);
  const auto normal = cross(rounded_vector<Real>(b) - origin, rounded_vector<Real>(c) - origin);
  return sign_of(dot(normal, d.w == 0 ? last : last - origin));
}

template <class Real>
std::int64_t grid_coordinate(Real numerator, Real denominator, int grid_bits) {
  const auto half_window = static_cast<Real>(std::int64_t{1} << static_cast<unsigned>(grid_bits));
  const Real place = std::round(numerator / denominator * half_window);
  return static_cast<std::int64_t>(std::clamp(place, -half_window, half_window));
}

template <class Real>
ImagePoint image_point_in(const Point3& vertex, const Camera& camera, const Precision& precision) {
  const auto from_origin = rounded_vector<Real>(vertex) - rounded_vector<Real>(camera.origin);
  const auto form = [&](const Vector3& row) { return dot(rounded_vector<Real>(row), from_origin); };
  const Real w = camera.projection == Projection::perspective ? form(camera.forward) : Real{1};
  const Real x = form(camera.right);
  const Real y = form(camera.up);
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
