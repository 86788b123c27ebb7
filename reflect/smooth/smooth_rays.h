// Rays from the camera, mirrored at a surface as its vertex normals have it.
//
// In:  the camera, a surface in view; a place of the window [-1, 1]^2.
// Out: the ray after it met the surface's plane there, as two points of it or a point and a direction. For a pinhole
//      the point is the mirror image of its eye at the tangent plane (Koucky's C_r), for an orthographic camera that
//      where the ray meets the plane: so that for equal normals point and direction are linear in the place. Nothing
//      where the ray does not meet the plane before the eye.
// Units: positions are those of the input times `scale`.
// Floating point. Complexity: that of ShadingNormals::at.
#pragma once

#include <optional>

#include "geometry/projection/camera.h"
#include "reflect/smooth/shading_normals.h"

namespace sightline::inline reflect {

struct MirroredRay {
  Point3 point = Point3::Zero();
  Vector3 direction = Vector3::Zero();
  double rise = 0;                      // the direction's part along the plane's normal that points to the camera
  Vector3 rightward = Vector3::Zero();  // the directions of the image, mirrored
  Vector3 upward = Vector3::Zero();
};

class SmoothRays {
 public:
  SmoothRays(const Camera& camera, const ShadingNormals& normals, const Point3& point_of_plane, double scale);

  [[nodiscard]] std::optional<MirroredRay> ray_at(double x, double y) const;

 private:
  // This is a ray of the camera.
  struct Ray {
    Point3 point = Point3::Zero();
    Vector3 direction = Vector3::Zero();
  };
  [[nodiscard]] Ray ray_through(double x, double y) const;

  bool perspective_;
  double scale_;
  Point3 origin_ = Point3::Zero();
  std::array<Vector3, 3> axes_;  // right . axes_[0] = 1, up . axes_[0] = 0, and so on
  const ShadingNormals& normals_;
  Point3 point_of_plane_ = Point3::Zero();
};

}  // namespace sightline::inline reflect
