#include "reflect/triangles/vertex_pyramid.h"

#include <algorithm>

namespace sightline::inline reflect {
namespace {

PlaneForm turned_towards(const PlaneForm& plane, const Point3& p) {
  return plane.at(p) < 0 ? PlaneForm{-1 * plane.normal, -plane.offset} : plane;
}

}  // namespace

VertexPyramid::VertexPyramid(const std::array<Point3, 3>& triangle, const HomogeneousPoint& eye,
                             const PlaneForm& panel) {
  const PlaneForm mirror = plane_form(triangle[0], triangle[1], triangle[2]);
  const auto mirrored = [&](const Vector3& v) -> Vector3 { return v - (2 * v.dot(mirror.normal)) * mirror.normal; };
  const Point3 middle = (1.0 / 3) * (triangle[0] + triangle[1] + triangle[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3& p = triangle[i];
    const Point3& q = triangle[(i + 1) % 3];
    const Vector3 to_centre = mirrored(eye.w == 0 ? eye.xyz : eye.xyz - p);
    forms_[i] = turned_towards(plane_across((q - p).cross(to_centre), p), triangle[(i + 2) % 3]);
  }
  forms_[3] = mirror;
  forms_[4] = turned_towards(panel, middle);
}

bool VertexPyramid::contains(const Point3& p) const {
  return std::ranges::all_of(forms_, [&](const PlaneForm& form) { return form.at(p) > 0; });
}

bool VertexPyramid::may_touch(const Box& box) const {
  return std::ranges::all_of(forms_, [&](const PlaneForm& form) { return form.highest(box) > 0; });
}

}  // namespace sightline::inline reflect
