#include "reflect/smooth/smooth_rays.h"

#include <cmath>

namespace sightline::inline reflect {
namespace {

Vector3 mirrored(const Vector3& direction, const Vector3& normal) {
  return direction - (2 * direction.dot(normal)) * normal;
}

bool is_finite(const Vector3& v) { return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()); }

}  // namespace

SmoothRays::SmoothRays(const Camera& camera, const ShadingNormals& normals, const Point3& point_of_plane, double scale)
    : perspective_(camera.projection == Projection::perspective),
      scale_(scale),
      origin_(scale * (perspective_ ? camera.eye.xyz : camera.origin)),
      normals_(normals),
      point_of_plane_(scale * point_of_plane) {
  const std::array across{camera.up.cross(camera.forward), camera.forward.cross(camera.right),
                          camera.right.cross(camera.up)};
  const double determinant = camera.right.dot(across[0]);
  for (std::size_t i = 0; i < 3; ++i) axes_[i] = (1 / determinant) * across[i];
}

SmoothRays::Ray SmoothRays::ray_through(double x, double y) const {
  const Vector3 beside = x * axes_[0] + y * axes_[1];
  if (perspective_) return {origin_, beside + axes_[2]};
  return {origin_ + scale_ * beside, axes_[2]};
}

std::optional<MirroredRay> SmoothRays::ray_at(double x, double y) const {
  const Ray ray = ray_through(x, y);
  const Vector3& plane_normal = normals_.of_plane();
  const double towards = plane_normal.dot(ray.direction);
  const double distance = plane_normal.dot(point_of_plane_ - ray.point) / towards;
  const Point3 place = ray.point + distance * ray.direction;
  if (!is_finite(place) || (perspective_ && distance <= 0)) return std::nullopt;
  const Vector3 normal = normals_.normal_at((1 / scale_) * place);
  MirroredRay result;
  result.direction = mirrored(ray.direction, normal);
  result.point = perspective_ ? place + mirrored(ray.point - place, normal) : place;
  result.rise = (towards < 0 ? 1 : -1) * plane_normal.dot(result.direction);
  result.rightward = mirrored(axes_[0], normal);
  result.upward = mirrored(axes_[1], normal);
  if (!is_finite(result.point) || !is_finite(result.direction)) return std::nullopt;
  return result;
}

}  // namespace sightline::inline reflect
