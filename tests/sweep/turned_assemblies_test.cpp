// Assemblies, turned: plates in contact or with a little play, bolts through all of them, boards that stick in them aslant. What
// is seen of each face does not depend on how the whole, with its camera, is turned: not at all where the turn is exact, and
// by no more than moved corners can change where it rounds them.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "geometry/cutting/interpenetration.h"
#include "tests/tools/polygon_mesh.h"
#include "tests/tools/unrounded_areas.h"

namespace sightline::tests::turned_assemblies_test {
namespace {

constexpr unsigned seed = 20261130;
constexpr double unit = 1000;  // what play is a thousandth of

struct Assembly {
  std::vector<Corners> faces;

  // A prism on an outline in x and y, seen counter-clockwise from above, between two heights; leaning by what is added to its
  // upper end.
  void add_prism(const Corners& outline, double low, double high, const Vector3& leaning = Vector3::Zero()) {
    Corners bottom;
    Corners top;
    for (const Point3& p : outline) {
      bottom.push_back(p + Vector3(0, 0, low));
      top.push_back(p + Vector3(0, 0, high) + leaning);
    }
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) faces.push_back({bottom[i], bottom[(i + 1) % n], top[(i + 1) % n], top[i]});
    faces.push_back(top);
    std::ranges::reverse(bottom);
    faces.push_back(bottom);
  }
};

Corners rectangle(double half_x, double half_y, const Vector3& at = Vector3::Zero()) {
  return {at + Vector3(-half_x, -half_y, 0), at + Vector3(half_x, -half_y, 0), at + Vector3(half_x, half_y, 0),
          at + Vector3(-half_x, half_y, 0)};
}

Corners octagon(double wide, double narrow, const Vector3& at) {
  Corners result;
  for (const auto& [x, y] : {std::pair{wide, -narrow},
                             {wide, narrow},
                             {narrow, wide},
                             {-narrow, wide},
                             {-wide, narrow},
                             {-wide, -narrow},
                             {-narrow, -wide},
                             {narrow, -wide}})
    result.push_back(at + Vector3(x, y, 0));
  return result;
}

// All coordinates are whole numbers.
std::vector<Corners> assembly(std::mt19937& random) {
  const auto between = [&random](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  Assembly parts;
  const double play = random() % 2 == 0 ? 0 : 1;
  for (int plate = 0; plate < 3; ++plate)
    parts.add_prism(rectangle(unit - 100 * (plate % 2), unit), 300 * plate, 300 * (plate + 1) - play);
  for (const double x : {-600.0, 600.0}) parts.add_prism(octagon(120, 50, {x, between(-500, 500), 0}), -100, 1100);
  parts.add_prism(rectangle(between(30, 200), 40, {between(-300, 300), 0, 0}), between(100, 250), 1300,
                  {between(-400, 400), between(-400, 400), 0});
  return parts.faces;
}

// Whole numbers again: the camera's rows, and where it stands. |forward| does not matter without near and far.
Camera whole_camera(std::mt19937& random) {
  const auto place = [&random](int reach) {
    return static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(2 * reach)) - reach);
  };
  Camera camera;
  camera.name = "whole";
  const Vector3 towards{place(8), place(8), 9};
  camera.origin = 500 * towards + Vector3(place(300), place(300), place(300));
  camera.eye = {camera.origin, 1};
  const Vector3 across = Vector3(0, 1, 0).cross(towards);
  camera.forward = -4 * towards;
  camera.right = 16 * across;
  camera.up = towards.cross(across);
  return camera;
}

// A turn times the square of its quaternion's length: entries are whole numbers.
Eigen::Matrix3d whole_turn(std::mt19937& random) {
  const auto part = [&random] { return static_cast<double>(random() % 9) - 4; };
  const Eigen::Quaterniond q(part() + 5, part(), part(), part());
  return std::round(q.squaredNorm()) * q.normalized().toRotationMatrix();
}

Eigen::Matrix3d rounded(const Eigen::Matrix3d& m) { return m.array().round(); }

std::vector<Corners> mapped(std::vector<Corners> faces, const Eigen::Matrix3d& m) {
  for (Corners& face : faces) {
    for (Point3& p : face) p = m * p;
  }
  return faces;
}

Camera mapped(Camera camera, const Eigen::Matrix3d& m) {
  for (Vector3* row : {&camera.right, &camera.up, &camera.forward, &camera.origin}) *row = m * *row;
  camera.eye.xyz = camera.origin;
  return camera;
}

struct Hardness {
  std::size_t crossing = 0;
  std::size_t touching = 0;
  std::size_t along_swaps = 0;
};

}  // namespace

TEST_CASE("assemblies show the same areas, as rationals, however they are turned exactly") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  Hardness hardness;
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const std::vector<Corners> faces = assembly(random);
    const Camera camera = whole_camera(random);
    const MeshContacts contacts = find_contacts(mesh_of(faces));
    hardness.crossing += contacts.crossing.size();
    hardness.touching += contacts.touching.size();
    const UnroundedAreas upright = unrounded_areas(mesh_of(faces), camera, Sides::both);
    hardness.along_swaps += upright.along_swaps;
    for (int turn = 0; turn < 4; ++turn) {
      const Eigen::Matrix3d m = rounded(whole_turn(random));
      REQUIRE((m.transpose() * m).isDiagonal(0));
      const UnroundedAreas turned = unrounded_areas(mesh_of(mapped(faces, m)), mapped(camera, m), Sides::both);
      CHECK(turned.of_face == upright.of_face);
    }
  }
  MESSAGE(hardness.crossing << " pairs cross, " << hardness.touching << " touch, " << hardness.along_swaps
                            << " segments along swap edges");
  CHECK(hardness.crossing > 400);
  CHECK(hardness.touching > 100);
  CHECK(hardness.along_swaps > 200);
}

// A turn in doubles moves a corner by at most 2^-50 of its distance from the middle; its image by less than 2^-48, as all of
// it is several times as far from the eye as it is large. No border of what is seen is nearer to parallel to another than one
// in a thousand, so each moves by less than 2^-38 of the window, which is 2 across.
TEST_CASE("assemblies show nearly the same areas however they are turned in doubles") {
  constexpr double moved = 0x1p-37;
  INFO("seed ", seed + 1);
  std::mt19937 random(seed + 1);
  std::uniform_real_distribution<double> angle(0, 6);
  double worst = 0;
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const std::vector<Corners> faces = assembly(random);
    const Camera camera = whole_camera(random);
    const UnroundedAreas upright = unrounded_areas(mesh_of(faces), camera, Sides::both);
    for (int turn = 0; turn < 4; ++turn) {
      const Eigen::Matrix3d m =
          Eigen::AngleAxisd(angle(random), Vector3(angle(random), 1, angle(random)).normalized()).toRotationMatrix();
      const UnroundedAreas turned = unrounded_areas(mesh_of(mapped(faces, m)), mapped(camera, m), Sides::both);
      for (std::size_t f = 0; f < faces.size(); ++f) {
        const boost::multiprecision::cpp_rational difference = turned.of_face[f] - upright.of_face[f];
        worst = std::max(worst, std::fabs(difference.convert_to<double>()));
      }
    }
  }
  MESSAGE("at most " << worst << " apart, of a window of 4");
  CHECK(worst < moved);
}

}  // namespace sightline::tests::turned_assemblies_test
