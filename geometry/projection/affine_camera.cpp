#include "geometry/projection/affine_camera.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>

namespace sightline::inline geometry {

namespace {

using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::array<Rational, 3>;

RationalVector rational_row(const Matrix34& p, int i) {
  return {Rational(p(i, 0)), Rational(p(i, 1)), Rational(p(i, 2))};
}

RationalVector cross_product(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot_product(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool is_zero(const RationalVector& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

Rational magnitude(const Rational& value) { return value < 0 ? Rational(-value) : value; }

// Returns v / divisor, each component rounded once; no component is -0.0.
Vector3 rounded_quotient(const RationalVector& v, const Rational& divisor) {
  const auto component = [&](std::size_t i) { return Rational(v[i] / divisor).convert_to<double>() + 0.0; };
  return {component(0), component(1), component(2)};
}

// Its largest component is 1, so that none overflows.
Vector3 rounded_direction(const RationalVector& v) {
  const Rational largest = std::max({magnitude(v[0]), magnitude(v[1]), magnitude(v[2])});
  return rounded_quotient(v, largest);
}

// Returns the point o of the plane through 0 across the rays with a . o = x and b . o = y.
Point3 solution(const RationalVector& a, const RationalVector& b, const Rational& x, const Rational& y) {
  const RationalVector along = cross_product(a, b);
  const RationalVector of_x = cross_product(b, along);
  const RationalVector of_y = cross_product(along, a);
  RationalVector sum;
  for (std::size_t i = 0; i < 3; ++i) sum[i] = x * of_x[i] + y * of_y[i];
  return rounded_quotient(sum, dot_product(along, along));
}

// The rows scaled so that pixels over the half of the image's size are the window.
Vector3 window_row(const RationalVector& row, const Rational& w, double size, int sign) {
  return rounded_quotient(row, w * Rational(size) / (2 * sign));
}

}  // namespace

bool is_affine(const Matrix34& p) { return p(2, 0) == 0 && p(2, 1) == 0 && p(2, 2) == 0; }

bool is_regular_affine(const Matrix34& p) {
  return p(2, 3) != 0 && !is_zero(cross_product(rational_row(p, 0), rational_row(p, 1)));
}

Camera affine_camera(std::string name, const Matrix34& p, const PixelImage& image) {
  const RationalVector a = rational_row(p, 0);
  const RationalVector b = rational_row(p, 1);
  const Rational w(p(2, 3));
  const int down = image.y == ImageY::down ? 1 : -1;
  const Rational shift(image.origin == PixelOrigin::center ? 0.5 : 0.0);
  Camera camera;
  camera.name = std::move(name);
  camera.projection = Projection::orthographic;
  camera.right = window_row(a, w, image.width, 1);
  camera.up = window_row(b, w, image.height, -down);
  const Vector3 along = down * rounded_direction(cross_product(a, b));
  camera.forward = unit(along);
  camera.eye = {Vector3(-along.array() + 0.0), 0};
  camera.origin = solution(a, b, w * (Rational(image.width) / 2 - shift) - Rational(p(0, 3)),
                           w * (Rational(image.height) / 2 - shift) - Rational(p(1, 3)));
  camera.aspect = image.width / image.height;
  return camera;
}

}  // namespace sightline::inline geometry
