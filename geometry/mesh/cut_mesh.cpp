#include "geometry/mesh/cut_mesh.h"

#include "geometry/numbers/predicates.h"

namespace sightline::inline geometry {

CutMesh uncrossed(Mesh mesh) {
  CutMesh result;
  static_cast<PolygonMesh&>(result) = std::move(mesh);
  return result;
}

ExactPosition exact_position(const CutMesh& mesh, VertexId v) {
  const std::size_t of_input = mesh.input_vertex_count();
  return v.index() < of_input ? exact_position(mesh.position(v)) : mesh.cuts.points[v.index() - of_input];
}

bool collinear(const CutMesh& mesh, VertexId a, VertexId b, VertexId c) {
  const std::size_t of_input = mesh.input_vertex_count();
  if (a.index() < of_input && b.index() < of_input && c.index() < of_input)
    return collinear(mesh.position(a), mesh.position(b), mesh.position(c));
  return collinear(exact_position(mesh, a), exact_position(mesh, b), exact_position(mesh, c));
}

}  // namespace sightline::inline geometry
