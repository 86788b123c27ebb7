// A surface in matrices of one's own, vertices V (n x 3) and faces F (m x 3), goes in; a label per triangle of the
// refined surface comes out, and the row of F that the triangle is a piece of.
//   own_matrices
#include <sightline/sightline.h>

#include <Eigen/Core>
#include <cstdlib>
#include <iostream>

using namespace sightline;

int main() try {
  // A triangle in front of a larger one.
  const Eigen::MatrixX3d v{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}, {-3, -2, 0}, {3, -2, 0}, {0, 3, 0}};
  const Eigen::MatrixXi f{{0, 1, 2}, {3, 4, 5}};
  const Camera camera = perspective_camera("front", {.eye = {0, 0, 9}, .target = {0, 0, 0}}, 60);

  const View view = Analyzer(build_mesh(v, f)).view(camera);
  const SurfaceMatrices surface = surface_matrices(view.labelled);
  for (Eigen::Index i = 0; i < surface.F.rows(); ++i) {
    std::cout << "face " << surface.parent(i) << ": " << to_string(static_cast<Label>(surface.label(i))) << '\n';
  }
  std::cout << "visible areas: " << visible_areas(view).transpose() << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
