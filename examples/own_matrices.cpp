// A surface in matrices of one's own, vertices V (n x 3) and faces F (m x 3), goes in; a label per triangle of the
// refined surface comes out, and the row of F that the triangle is a piece of.
//   own_matrices
#include <sightline/sightline.h>

#include <Eigen/Core>
#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

using namespace sightline;

namespace {

Mesh mesh_of(const Eigen::MatrixX3d& v, const Eigen::MatrixX3i& f) {
  std::vector<Point3> vertices;
  for (const auto& row : v.rowwise()) vertices.push_back({row(0), row(1), row(2)});
  PolygonList faces;
  for (const auto& row : f.cast<std::size_t>().rowwise()) {
    faces.push_back(std::array{VertexId{row(0)}, VertexId{row(1)}, VertexId{row(2)}});
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

// Per triangle of the refined surface: a row of F, and its Label.
Eigen::MatrixX2i labels_of(const LabelledMesh& labelled) {
  Eigen::MatrixX2i labels(labelled.triangles.size(), 2);
  for (Eigen::Index i = 0; i < labels.rows(); ++i) {
    const LabelledTriangle& triangle = labelled.triangles[static_cast<std::size_t>(i)];
    labels.row(i) << static_cast<int>(triangle.face.value), static_cast<int>(triangle.label);
  }
  return labels;
}

}  // namespace

int main() try {
  // A triangle in front of a larger one.
  const Eigen::MatrixX3d v{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}, {-3, -2, 0}, {3, -2, 0}, {0, 3, 0}};
  const Eigen::MatrixX3i f{{0, 1, 2}, {3, 4, 5}};
  const Camera camera = perspective_camera("front", {.eye = {0, 0, 9}, .target = {0, 0, 0}}, 60);

  const Eigen::MatrixX2i labels = labels_of(analyze(mesh_of(v, f), camera).labelled);
  for (const auto& row : labels.rowwise()) {
    std::cout << "face " << row(0) << ": " << to_string(static_cast<Label>(row(1))) << '\n';
  }
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
