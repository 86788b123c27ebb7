// The normals of one surface, interpolated between its corners.
//
// In:  a surface in view (a planar face, or a facet), the normals at the corners of its face (vertex_normals.h).
// Out: the normal at a point of its plane: in barycentric coordinates of the surface's triangle in which the point is;
//      beyond the surface, of the triangle nearest by these coordinates, as far as the triangle is large, then
//      constant.
// Floating point. Complexity: O(k) per point for k corners.
// Source: Koucky 2014, 3.9 (vertex normals); Phong's interpolation.
#pragma once

#include <array>
#include <vector>

#include "geometry/mesh/cut_mesh.h"

namespace sightline::inline reflect {

class ShadingNormals {
 public:
  ShadingNormals(const CutMesh& mesh, const std::vector<Vector3>& vertex_normals, FacetId surface);

  // The normal has length 1.
  [[nodiscard]] Vector3 normal_at(const Point3& p) const;
  [[nodiscard]] const Vector3& of_plane() const { return plane_normal_; }

 private:
  // A point a + u + v has the barycentric coordinate (u + v) . to_second at the second corner, and so on.
  struct Triangle {
    Point3 first = Point3::Zero();
    Vector3 to_second = Vector3::Zero();
    Vector3 to_third = Vector3::Zero();
    std::array<Vector3, 3> normals;
  };

  void add(const CutMesh& mesh, const std::vector<Vector3>& vertex_normals, FaceId face,
           const std::array<VertexId, 3>& corners);

  double scale_;
  Vector3 plane_normal_ = Vector3::Zero();
  std::vector<Triangle> triangles_;
};

}  // namespace sightline::inline reflect
