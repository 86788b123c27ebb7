// An affine map: where a part of a mesh stands.
//
// Holds: an identity keeps every coordinate's value; what else is mapped is rounded, in double.
#pragma once

#include <array>

#include "geometry/numbers/vector3.h"

namespace sightline::inline formats {

struct Placement {
  // The images of the axes, and of the origin.
  std::array<Vector3, 3> axes{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  Vector3 origin = Vector3::Zero();

  [[nodiscard]] Vector3 direction(const Vector3& d) const {
    return d.x() * axes[0] + d.y() * axes[1] + d.z() * axes[2];
  }
  [[nodiscard]] Point3 point(const Point3& p) const { return direction(p) + origin; }
  // Returns whether it turns right hands into left ones: then faces turn round to keep their front.
  [[nodiscard]] bool mirrors() const { return axes[0].cross(axes[1]).dot(axes[2]) < 0; }
  // Returns a vector across the image of the plane that n is across, of any length; on the same side.
  [[nodiscard]] Vector3 normal(const Vector3& n) const {
    const Vector3 across =
        n.x() * axes[1].cross(axes[2]) + n.y() * axes[2].cross(axes[0]) + n.z() * axes[0].cross(axes[1]);
    return mirrors() ? Vector3(-across) : across;
  }
};

// Returns what the inner placement does, then the outer one.
[[nodiscard]] inline Placement operator*(const Placement& outer, const Placement& inner) {
  Placement both;
  for (std::size_t i = 0; i < 3; ++i) both.axes[i] = outer.direction(inner.axes[i]);
  both.origin = outer.point(inner.origin);
  return both;
}

}  // namespace sightline::inline formats
