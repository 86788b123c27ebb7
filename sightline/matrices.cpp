#include "sightline/matrices.h"

#include <stdexcept>

#include "geometry/mesh/area.h"

namespace sightline {
namespace {

std::vector<VertexId> corners_of(const Eigen::RowVectorXi& row) {
  std::vector<VertexId> corners;
  for (const int vertex : row) {
    if (corners.size() == 3 && vertex == -1) break;
    if (vertex < 0) throw std::invalid_argument("F has a negative vertex number");
    corners.emplace_back(static_cast<std::size_t>(vertex));
  }
  return corners;
}

}  // namespace

Mesh build_mesh(const Eigen::MatrixX3d& V, const Eigen::MatrixXi& F) {
  if (F.cols() != 3 && F.cols() != 4) throw std::invalid_argument("F has neither 3 nor 4 columns");
  std::vector<Point3> vertices;
  for (Eigen::Index v = 0; v < V.rows(); ++v) vertices.emplace_back(V(v, 0), V(v, 1), V(v, 2));
  PolygonList faces;
  for (Eigen::Index f = 0; f < F.rows(); ++f) faces.push_back(corners_of(F.row(f)));
  return build_mesh(std::move(vertices), std::move(faces));
}

SurfaceMatrices surface_matrices(const LabelledMesh& labelled) {
  const auto n = static_cast<Eigen::Index>(labelled.vertices.size());
  const auto m = static_cast<Eigen::Index>(labelled.triangles.size());
  SurfaceMatrices surface{Eigen::MatrixX3d(n, 3), Eigen::MatrixX3i(m, 3), Eigen::VectorXi(m), Eigen::VectorXi(m)};
  for (Eigen::Index v = 0; v < n; ++v) surface.V.row(v) = labelled.vertices[static_cast<std::size_t>(v)].transpose();
  for (Eigen::Index t = 0; t < m; ++t) {
    const LabelledTriangle& triangle = labelled.triangles[static_cast<std::size_t>(t)];
    for (Eigen::Index i = 0; i < 3; ++i)
      surface.F(t, i) = static_cast<int>(triangle.corners[static_cast<std::size_t>(i)].value);
    surface.parent(t) = static_cast<int>(triangle.face.value);
    surface.label(t) = static_cast<int>(triangle.label);
  }
  return surface;
}

Eigen::VectorXd visible_areas(const View& view) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(view.mesh().face_count()));
  for (const LabelledTriangle& t : view.labelled.triangles) {
    const auto corner = [&](std::size_t i) -> const Point3& { return view.labelled.vertices[t.corners[i].index()]; };
    if (t.label == Label::visible)
      areas(static_cast<Eigen::Index>(t.face.index())) += triangle_area(corner(0), corner(1), corner(2));
  }
  return areas;
}

}  // namespace sightline
