#include "tests/tools/unrounded_scenes.h"

#include <cmath>

#include "oracle/judging/judge.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests {

Mesh moved(const lattice::RandomScene& scene, Moved how) {
  std::mt19937_64 random(scene.seed);
  std::uniform_real_distribution<double> angle(-0.02, 0.02);
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(angle(random), Vector3(1, 2, 3).normalized()) *
                                Eigen::AngleAxisd(angle(random), Vector3(-2, 1, 1).normalized()))
                                   .toRotationMatrix();
  lattice::RandomScene result = scene;
  for (Point3& p : result.vertices) {
    if (how == Moved::turned) p = Point3(turn * p);
    for (Eigen::Index i = 0; i < 3 && how == Moved::by_last_bits; ++i) {
      if (random() % 3 == 0) p[i] = std::nextafter(p[i], random() % 2 == 0 ? 1e9 : -1e9);
    }
    for (Eigen::Index i = 0; i < 3 && how == Moved::by_parts_of_spacings; ++i)
      p[i] += 0x1p-43 * static_cast<double>(random() % 17) - 0x1p-40;
  }
  return mesh_of(result);
}

Mesh few_points_soup(std::mt19937_64& random) {
  const auto place = [&random] { return static_cast<double>(random() % 5) - 2; };
  std::vector<Corners> faces(5 + random() % 6);
  for (Corners& face : faces) {
    face = {{place(), place(), place()}, {place(), place(), place()}, {place(), place(), place()}};
    if (random() % 4 == 0) face.push_back(face[0] + face[2] - face[1]);
  }
  return mesh_of(faces);
}

Camera on_grid_camera(std::mt19937_64& random) {
  const auto place = [&random] { return static_cast<double>(random() % 9) - 4; };
  ViewPoint view;
  view.eye = {place(), place(), random() % 2 == 0 ? 5.0 : 2.0};
  view.target = {place() / 4, place() / 4, -1};
  return random() % 3 == 0 ? orthographic_camera("grid", view, 6) : perspective_camera("grid", view, 90);
}

}  // namespace sightline::tests
