#include "oracle/scenes/moved_scene.h"

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace sightline::lattice {

Mesh moved(const RandomScene& scene, Moved how) {
  std::mt19937_64 random(scene.seed);
  std::uniform_real_distribution<double> angle(-0.02, 0.02);
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(angle(random), Vector3(1, 2, 3).normalized()) *
                                Eigen::AngleAxisd(angle(random), Vector3(-2, 1, 1).normalized()))
                                   .toRotationMatrix();
  RandomScene result = scene;
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

}  // namespace sightline::lattice
