#include "reflect/smooth/shading_normals.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/vector3.h"
#include "reflect/world/mirror_world.h"
#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {
namespace {

// Returns the normal at the face's corner that is this vertex; zero where there are none.
Vector3 corner_normal(const CutMesh& mesh, const std::vector<Vector3>& normals, FaceId face, VertexId vertex) {
  if (normals.empty()) return Vector3::Zero();
  const auto corners = mesh.faces[face.index()];
  const auto corner = std::ranges::find(corners, vertex);
  if (corner == corners.end()) return Vector3::Zero();
  return normals[mesh.faces.begin[face.index()] + static_cast<std::size_t>(corner - corners.begin())];
}

double clamped(double barycentric) { return std::clamp(barycentric, -1.0, 2.0); }

}  // namespace

ShadingNormals::ShadingNormals(const CutMesh& mesh, const std::vector<Vector3>& vertex_normals, FacetId surface) {
  const std::array<Point3, 3> plane = plane_points(mesh, surface);
  scale_ = unit_scale(plane);
  plane_normal_ = unit((scale_ * plane[1] - scale_ * plane[0]).cross(scale_ * plane[2] - scale_ * plane[0]));
  for (const auto& corners : fans_of(mesh, surface))
    add(mesh, vertex_normals, mesh.facet_face[surface.index()], corners);
}

void ShadingNormals::add(const CutMesh& mesh, const std::vector<Vector3>& vertex_normals, FaceId face,
                         const std::array<VertexId, 3>& corners) {
  const auto position = [&](std::size_t i) -> Vector3 { return scale_ * mesh.position(corners[i]); };
  const Vector3 second = position(1) - position(0);
  const Vector3 third = position(2) - position(0);
  const Vector3 normal = second.cross(third);
  const double square = normal.dot(normal);
  if (!(square > 0)) return;
  Triangle triangle{position(0), (1 / square) * third.cross(normal), (1 / square) * normal.cross(second), {}};
  for (std::size_t i = 0; i < 3; ++i) triangle.normals[i] = corner_normal(mesh, vertex_normals, face, corners[i]);
  triangles_.push_back(triangle);
}

Vector3 ShadingNormals::normal_at(const Point3& p) const {
  Vector3 found = Vector3::Zero();
  double least_of_found = 0;
  for (const Triangle& triangle : triangles_) {
    const Vector3 from_first = scale_ * p - triangle.first;
    const double second = from_first.dot(triangle.to_second);
    const double third = from_first.dot(triangle.to_third);
    const double least = std::min({1 - second - third, second, third});
    if (found != Vector3::Zero() && least <= least_of_found) continue;
    least_of_found = least;
    found = clamped(1 - second - third) * triangle.normals[0] + clamped(second) * triangle.normals[1] +
            clamped(third) * triangle.normals[2];
  }
  const Vector3 normal = unit(found);
  return normal == Vector3::Zero() ? plane_normal_ : normal;
}

}  // namespace sightline::inline reflect
