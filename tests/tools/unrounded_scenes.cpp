#include "tests/tools/unrounded_scenes.h"

#include <cmath>

#include "tests/tools/polygon_mesh.h"

namespace sightline::tests {
namespace {

Vector3 random_vector(std::mt19937_64& random, double reach) {
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

// A point along a segment, off it by no more than last bits.
Point3 nearly_between(const Point3& a, const Point3& b, std::mt19937_64& random) {
  const double share = std::uniform_real_distribution<double>(0, 1)(random);
  return a + share * (b - a) + random_vector(random, 0x1p-52 * static_cast<double>(random() % 4));
}

Corners extreme_face(const std::vector<Corners>& before, std::mt19937_64& random) {
  const Point3 middle = Point3(0, 0, -2) + random_vector(random, 0.8);
  Corners face;
  for (int i = 0; i < 3; ++i) face.push_back(middle + random_vector(random, 1));
  switch (random() % 5) {
    case 0:
      face[2] = nearly_between(face[0], face[1], random);
      break;
    case 1:  // nearly edge-on: the eye is nearly in its plane
      face[2] = (1 + std::ldexp(1.0, -static_cast<int>(random() % 6))) * nearly_between(face[0], face[1], random);
      break;
    case 2:
      if (before.empty()) break;
      face = before[random() % before.size()];
      for (Point3& p : face) p += random_vector(random, std::ldexp(p.norm(), -static_cast<int>(random() % 52)));
      break;
    default:
      break;
  }
  return face;
}

}  // namespace

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

Mesh extreme_soup(std::mt19937_64& random) {
  const auto distance = [&random] { return std::ldexp(1.0, 400 * (static_cast<int>(random() % 3) - 1)); };
  std::vector<Corners> faces;
  const std::size_t count = 3 + random() % 4;
  const double of_all = distance();
  while (faces.size() < count) faces.push_back(extreme_face(faces, random));
  for (Corners& face : faces) {
    const double of_face = random() % 4 == 0 ? distance() : of_all;
    const bool in_one_face = random() % 6 == 0;
    for (Point3& p : face) p *= in_one_face ? distance() : of_face;
  }
  return mesh_of(faces);
}

Camera camera_in_origin() {
  ViewPoint view;
  view.target = {0, 0, -1};
  return perspective_camera("origin", view, 90);
}

}  // namespace sightline::tests
