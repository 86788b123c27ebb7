#include "geometry/mesh/vertex_normals.h"

namespace sightline::inline geometry {
namespace {

// Returns twice the area of a face, which need not be planar, as a vector.
Vector3 area_vector(const PolygonMesh& mesh, FaceId face, double scale) {
  const auto corners = mesh.faces[face.index()];
  const auto position = [&](std::size_t i) -> Vector3 { return scale * mesh.position(corners[i]); };
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum = sum + (position(i) - position(0)).cross(position(i + 1) - position(0));
  return sum;
}

// Returns the sum over the faces around each vertex that stands for its position (Mesh::weld).
std::vector<Vector3> sums_at_positions(const PolygonMesh& mesh) {
  const double scale = unit_scale(mesh.vertices);
  std::vector<Vector3> sums(mesh.vertices.size(), Vector3::Zero());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.first_facet(FaceId(f)) == mesh.end_facet(FaceId(f))) continue;
    const Vector3 area = area_vector(mesh, FaceId(f), scale);
    for (const VertexId corner : mesh.faces[f]) {
      Vector3& sum = sums[mesh.weld[corner.index()].index()];
      sum = sum + area;
    }
  }
  return sums;
}

}  // namespace

std::vector<Vector3> vertex_normals(const PolygonMesh& mesh, const std::vector<Vector3>& given) {
  const std::vector<Vector3> sums = sums_at_positions(mesh);
  std::vector<Vector3> normals;
  normals.reserve(mesh.faces.corners.size());
  for (std::size_t i = 0; i < mesh.faces.corners.size(); ++i) {
    const bool is_given = i < given.size() && given[i] != Vector3::Zero();
    normals.push_back(unit(is_given ? given[i] : sums[mesh.weld[mesh.faces.corners[i].index()].index()]));
  }
  return normals;
}

}  // namespace sightline::inline geometry
