// A plane in floating point is a form that is positive on its front side.
#pragma once

#include "geometry/mesh/box_hierarchy.h"
#include "geometry/numbers/vector3.h"

namespace sightline::inline reflect {

struct PlaneForm {
  Vector3 normal = Vector3::Zero();
  double offset = 0;

  [[nodiscard]] double at(const Point3& p) const { return normal.dot(p) - offset; }

  // These are the form's least and its greatest value in a box.
  [[nodiscard]] double lowest(const Box& box) const {
    return at({normal.x() < 0 ? box.high.x() : box.low.x(), normal.y() < 0 ? box.high.y() : box.low.y(),
               normal.z() < 0 ? box.high.z() : box.low.z()});
  }
  [[nodiscard]] double highest(const Box& box) const {
    return at({normal.x() < 0 ? box.low.x() : box.high.x(), normal.y() < 0 ? box.low.y() : box.high.y(),
               normal.z() < 0 ? box.low.z() : box.high.z()});
  }
};

[[nodiscard]] inline PlaneForm plane_across(const Vector3& normal, const Point3& p) { return {normal, normal.dot(p)}; }

// In front of the plane a, b, c are seen counter-clockwise.
[[nodiscard]] inline PlaneForm plane_form(const Point3& a, const Point3& b, const Point3& c) {
  return plane_across(unit((b - a).cross(c - a)), a);
}

}  // namespace sightline::inline reflect
