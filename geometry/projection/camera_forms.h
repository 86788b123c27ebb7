// A camera's linear forms in a number type: double, float, integers, or numbers with error bounds.
//
// In:  a camera, and what turns a double into the number type. As integers, doubles are multiples of a power of two that
//      they have in common, 1 / unit.
// Out: of a point v its X, Y, W and depth as camera.h defines them, times unit^2; of a point v / weight, times the weight
//      as well.
// Holds: every form is evaluated in one order, (x + y) + z, which error bounds suppose.
#pragma once

#include <span>

#include "geometry/numbers/exact_integer.h"
#include "geometry/projection/camera.h"

namespace sightline::inline geometry {

template <class Scalar>
struct CameraPlace {
  Scalar x, y, w, depth;
};

template <class Scalar>
struct CameraForms {
  using Vector = Eigen::Matrix<Scalar, 3, 1>;

  bool perspective = true;
  Vector right, up, forward, origin;
  Scalar unit;  // what 1 is turned into
  Scalar one;   // unit^2

  template <class Convert>
  CameraForms(const Camera& camera, Convert number) : CameraForms(camera, number, number(1.0) * number(1.0)) {}
  // In a type that doubles are numbers of.
  explicit CameraForms(const Camera& camera)
      : CameraForms(
            camera, [](double value) { return Scalar(value); }, Scalar(1.0)) {}

  [[nodiscard]] CameraPlace<Scalar> at(const Vector& v) const { return from_origin(v - origin, one); }
  [[nodiscard]] CameraPlace<Scalar> at(const Vector& v, const Scalar& weight) const {
    return from_origin(v - weight * origin, one * weight);
  }
  [[nodiscard]] Scalar depth_at(const Vector& v) const { return value(forward, v - origin); }

  [[nodiscard]] static Scalar value(const Vector& row, const Vector& v) {
    return (row.x() * v.x() + row.y() * v.y()) + row.z() * v.z();
  }

 private:
  template <class Convert>
  CameraForms(const Camera& camera, Convert number, const Scalar& square)
      : perspective(camera.projection == Projection::perspective),
        right(camera.right.unaryExpr(number)),
        up(camera.up.unaryExpr(number)),
        forward(camera.forward.unaryExpr(number)),
        origin(camera.origin.unaryExpr(number)),
        unit(number(1.0)),
        one(square) {}

  [[nodiscard]] CameraPlace<Scalar> from_origin(const Vector& offset, const Scalar& weight) const {
    const Scalar depth = value(forward, offset);
    return {value(right, offset), value(up, offset), perspective ? depth : weight, depth};
  }
};

// The largest power of two, as its exponent, of which the camera's numbers, the points' coordinates and 1 are multiples.
[[nodiscard]] int common_exponent(const Camera& camera, std::span<const Point3> points = {});

[[nodiscard]] CameraForms<BigInteger> integer_forms(const Camera& camera, int exponent);

}  // namespace sightline::inline geometry
