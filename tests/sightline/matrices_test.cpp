// Matrices in and out: the same surface as by vertices and faces, and what cannot be one is refused.
#include "sightline/matrices.h"

#include <doctest/doctest.h>

#include <stdexcept>

#include "sightline/analyzer.h"

namespace sightline::tests::matrices_test {
namespace {

const Eigen::MatrixX3d& corners() {
  static const Eigen::MatrixX3d V{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}, {2, 0, 1}, {0, 2, 1}};
  return V;
}

// A square on the floor, and a triangle over its quarter.
Eigen::MatrixXi square_and_triangle() { return Eigen::MatrixXi{{0, 1, 2, 3}, {4, 5, 6, -1}}; }

View seen_from_above(Mesh mesh) {
  ViewPoint view;
  view.eye = {0, 0, 5};
  view.target = {0, 0, 0};
  view.up = {0, 1, 0};
  return Analyzer(std::move(mesh), {.sides = SidesPolicy::both}).view(orthographic_camera("above", view, 4));
}

}  // namespace

TEST_CASE("matrices: a row of F is a face, and -1 in the fourth column makes it a triangle") {
  const Mesh mesh = build_mesh(corners(), square_and_triangle());
  REQUIRE(mesh.face_count() == 2);
  CHECK(mesh.faces[0].size() == 4);
  CHECK(mesh.faces[1].size() == 3);
  CHECK(mesh.faces[1][2] == VertexId(6));
  CHECK(mesh.position(VertexId(5)) == Point3(2, 0, 1));
}

TEST_CASE("matrices: the labelled surface has the view's vertices and triangles, and areas per face") {
  const View view = seen_from_above(build_mesh(corners(), square_and_triangle()));
  const SurfaceMatrices surface = surface_matrices(view.labelled);
  REQUIRE(surface.V.rows() == static_cast<Eigen::Index>(view.labelled.vertices.size()));
  CHECK(surface.V.topRows(7) == corners());
  double of_square = 0;
  for (Eigen::Index t = 0; t < surface.F.rows(); ++t) {
    const Eigen::Vector3d a = surface.V.row(surface.F(t, 0));
    const Eigen::Vector3d b = surface.V.row(surface.F(t, 1));
    const Eigen::Vector3d c = surface.V.row(surface.F(t, 2));
    const double area = (b - a).cross(c - a).norm() / 2;
    if (surface.parent(t) == 0 && surface.label(t) == static_cast<int>(Label::visible)) of_square += area;
  }
  // Of the square's 4 the triangle hides the quarter, less the corner beyond its long side, which has no area.
  CHECK(of_square == doctest::Approx(3).epsilon(1e-9));
  const Eigen::VectorXd areas = visible_areas(view);
  REQUIRE(areas.size() == 2);
  CHECK(areas(0) == doctest::Approx(3).epsilon(1e-9));
  CHECK(areas(1) == doctest::Approx(2).epsilon(1e-9));
}

TEST_CASE("matrices: what is no surface is refused") {
  CHECK_THROWS_AS((void)build_mesh(corners(), Eigen::MatrixXi{{0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS((void)build_mesh(corners(), Eigen::MatrixXi{{0, 1, 7}}), std::invalid_argument);
  CHECK_THROWS_AS((void)build_mesh(corners(), Eigen::MatrixXi{{0, -1, 2}}), std::invalid_argument);
  CHECK_THROWS_AS((void)build_mesh(corners(), Eigen::MatrixXi{{0, -1, 2, 3}}), std::invalid_argument);
  Eigen::MatrixX3d V = corners();
  V(3, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((void)build_mesh(V, square_and_triangle()), std::invalid_argument);
}

TEST_CASE("matrices: no faces are a surface without any") {
  const Mesh mesh = build_mesh(Eigen::MatrixX3d(0, 3), Eigen::MatrixXi(0, 3));
  CHECK(mesh.face_count() == 0);
}

}  // namespace sightline::tests::matrices_test
