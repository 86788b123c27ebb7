// A triangle of the surface as its vertex normals bend it, seen through a triangle of the image: what its mirrored rays do, as
// polynomials of the place in the image.
//
// In:  a camera; a triangle in space with a normal at each corner; a triangle of the window [-1, 1]^2.
// Out: conditions of a mirrored ray, which hold where a quartic is positive.
// Method: the ray of a place (x, y) runs along D(x, y), which is linear. It meets the triangle's plane at X / w, and there the
//      interpolated normal is N / w, all of these linear. Mirrored, it runs along R = (N . N) D - 2 (D . N) N, a cubic. It passes
//      the edge from p to q on the side that the sign of -R . (w p x q - X x (q - p)) tells, which is a quartic. All factors that
//      were left out are positive where the plane is before the camera.
// Rounding: no coefficient is off by more than the condition's noise. Corners have length 1 in N, so R is at most 3 |D|. Each
//      coefficient is a sum of products that takes fewer than 64 roundings, each at most u of the product of the factors' largest
//      coefficients: 64 u of these bounds.
// Units: positions are those of the input times a scale.
// Complexity: O(1) per condition.
// Source: Koucky 2014, 3.9 (rays mirrored at vertex normals). Polynomials instead of rays at corners are this project's.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/mesh/box_hierarchy.h"
#include "geometry/projection/camera.h"
#include "reflect/smooth/quartic.h"
#include "reflect/world/plane_form.h"

namespace sightline::inline reflect {

struct BentTriangle {
  std::array<Point3, 3> corners;
  std::array<Vector3, 3> normals;         // of length 1
  Vector3 towards_eye = Vector3::Zero();  // the normal of its plane, of length 1
};

// The condition is that the quartic is positive; what is not above the noise has no sign.
struct Condition {
  Quartic value;
  double noise = 0;
};

// What all mirrored rays stay in: the near sides of these planes.
class RayBeam {
 public:
  explicit RayBeam(std::vector<PlaneForm> sides) : sides_(std::move(sides)) {}

  // In units of the mirror. Returns false where no ray meets the box.
  [[nodiscard]] bool may_reach(const Box& box) const {
    return std::ranges::none_of(sides_, [&](const PlaneForm& side) { return side.lowest(box) > 0; });
  }

 private:
  std::vector<PlaneForm> sides_;
};

class BentMirror {
 public:
  using WindowTriangle = std::array<Point2, 3>;
  struct Plane {
    Vector3 normal = Vector3::Zero();
    Point3 point = Point3::Zero();
  };

  BentMirror(const Camera& camera, double scale, const BentTriangle& triangle, const WindowTriangle& window);

  // The ray leaves the side of the plane on which the eye is.
  [[nodiscard]] Condition rises() const;
  // The ray starts in front of a plane.
  [[nodiscard]] Condition starts_before(const Plane& plane) const;
  // The ray passes the edge on its left, seen along the ray.
  [[nodiscard]] Condition passes_left_of(const Point3& p, const Point3& q) const;
  // The ray, which starts in front of both planes and meets the first from there, meets it in front of the second.
  [[nodiscard]] Condition meets_before(const Plane& first, const Plane& second) const;

  // Returns what holds all its rays; or all that meet a polygon, as far as there.
  [[nodiscard]] RayBeam beam() const;
  [[nodiscard]] RayBeam beam_to(const std::vector<Point3>& polygon) const;

 private:
  template <class Value>
  using Cubic = BarycentricForm<3, Value>;

  [[nodiscard]] std::optional<std::array<Point3, 3>> starts() const;
  [[nodiscard]] std::vector<PlaneForm> sides_along(const std::vector<Vector3>& directions,
                                                   const std::array<Point3, 3>& starts) const;
  [[nodiscard]] LinearForm<double> height_over(const Plane& plane) const;
  [[nodiscard]] double largest_height(const Plane& plane) const;

  Point3 origin_ = Point3::Zero();  // what all positions here are relative to
  Vector3 towards_eye_ = Vector3::Zero();
  LinearForm<Vector3> place_;  // X
  LinearForm<double> weight_;  // w
  Cubic<Vector3> mirrored_;    // R
  double largest_place_ = 0;
  double largest_weight_ = 0;
  double largest_mirrored_ = 0;
};

}  // namespace sightline::inline reflect
