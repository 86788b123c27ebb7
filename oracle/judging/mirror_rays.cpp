#include "oracle/judging/mirror_rays.h"

#include <cmath>
#include <limits>

namespace sightline::lattice {
namespace {

double scalar(const Vector3& a, const Vector3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }
Vector3 vector_product(const Vector3& a, const Vector3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

// Returns where the ray meets the triangle, in multiples of the direction; infinite where it does not.
double distance_to(const std::array<Point3, 3>& corners, const Point3& origin, const Vector3& direction) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const Vector3 u = corners[1] - corners[0];
  const Vector3 v = corners[2] - corners[0];
  const Vector3 across = vector_product(direction, v);
  const double determinant = scalar(u, across);
  if (determinant == 0) return never;
  const Vector3 from_corner = origin - corners[0];
  const double along_u = scalar(from_corner, across) / determinant;
  const Vector3 beside = vector_product(from_corner, u);
  const double along_v = scalar(direction, beside) / determinant;
  if (along_u < 0 || along_v < 0 || along_u + along_v > 1) return never;
  const double distance = scalar(v, beside) / determinant;
  return distance > 0 ? distance : never;
}

}  // namespace

MirrorRays::MirrorRays(const PolygonMesh& mesh, const std::vector<Panel>& panels, const Camera& camera,
                       const std::vector<Vector3>& normals)
    : camera_(camera), is_bent_(!normals.empty()) {
  add(faces_, mesh, 0, false);
  for (std::size_t f = 0; is_bent_ && f < faces_.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) faces_[f].normals[i] = normals[3 * f + i].normalized();
  }
  for (std::size_t p = 0; p < panels.size(); ++p)
    add(panels_, panel_mesh(panels[p]), p, panels[p].emits == Emits::front);
}

void MirrorRays::add(std::vector<Target>& targets, const PolygonMesh& mesh, std::size_t owner, bool front_only) const {
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    const auto corners = mesh.corners(FacetId(f));
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const std::array triangle{mesh.position(corners[0]), mesh.position(corners[i]), mesh.position(corners[i + 1])};
      const Vector3 normal = vector_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
      targets.push_back({triangle, normal, owner + mesh.facet_face[f].index(), front_only});
    }
  }
}

// The ray starts on `from`; it and what lies in one face with it are not hit.
MirrorRays::Hit MirrorRays::first_hit(const std::vector<Target>& targets, const Point3& origin,
                                      const Vector3& direction, const Target* from) {
  Hit nearest{std::numeric_limits<double>::infinity(), nullptr};
  for (const Target& target : targets) {
    if (from != nullptr && target.owner == from->owner) continue;
    const double distance = distance_to(target.corners, origin, direction);
    if (distance < nearest.distance) nearest = {distance, &target};
  }
  return nearest;
}

// The normals are weighed by the areas of the triangles that the place makes with the sides.
Vector3 MirrorRays::normal_at(const Target& target, const Point3& place) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 p = target.corners[(i + 1) % 3] - place;
    const Vector3 q = target.corners[(i + 2) % 3] - place;
    sum = sum + scalar(vector_product(p, q), target.normal) * target.normals[i];
  }
  return sum;
}

int MirrorRays::panel_at(double x, double y) const {
  const Vector3 direction = camera_.forward + (x / scalar(camera_.right, camera_.right)) * camera_.right +
                            (y / scalar(camera_.up, camera_.up)) * camera_.up;
  const Hit mirror = first_hit(faces_, camera_.origin, direction, nullptr);
  if (mirror.target == nullptr) return -1;
  const Point3 place = camera_.origin + mirror.distance * direction;
  const Vector3 normal = is_bent_ ? normal_at(*mirror.target, place) : mirror.target->normal;
  const Vector3 mirrored = direction - (2 * scalar(direction, normal) / scalar(normal, normal)) * normal;
  const Vector3& flat = mirror.target->normal;
  if (is_bent_ && scalar(mirrored, flat) * scalar(direction, flat) >= 0) return -1;
  const Hit obstacle = first_hit(faces_, place, mirrored, mirror.target);
  const Hit panel = first_hit(panels_, place, mirrored, nullptr);
  if (panel.target == nullptr || panel.distance >= obstacle.distance) return -1;
  if (panel.target->front_only && scalar(mirrored, panel.target->normal) > 0) return -1;
  return static_cast<int>(panel.target->owner);
}

}  // namespace sightline::lattice
