// Faces that do not mirror: they reflect nothing, block all the same, and change nothing for the others; in each mode.
#include <doctest/doctest.h>

#include "oracle/judging/judge.h"
#include "reflect/triangles/reflecting_triangles.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::mirror_faces_test {
namespace {

// Two floors of eight triangles side by side, the left one face numbers 0 to 7, and a shade over a part of both: 16.
Mesh floors() {
  std::vector<Corners> triangles;
  for (const double x : {-2.0, 0.0}) {
    for (const double dx : {0.0, 1.0}) {
      for (const double y : {-1.0, 0.0}) {
        const Point3 low{x + dx, y, 0};
        triangles.push_back({low, low + Vector3(1, 0, 0), low + Vector3(1, 1, 0)});
        triangles.push_back({low, low + Vector3(1, 1, 0), low + Vector3(0, 1, 0)});
      }
    }
  }
  triangles.push_back({{-0.6, 0.2, 1}, {0.6, 0.2, 1}, {0, 0.8, 1}});
  return mesh_of(triangles);
}

const Panel lamp{"lamp", {{-2.5, -3, 4}, {2.5, -3, 4}, {2.5, 3, 4}, {-2.5, 3, 4}}, Emits::both};

View viewed(ReflectionMode mode, std::vector<std::uint8_t> mirror_faces) {
  ReflectionOptions reflection{.mode = mode};
  reflection.tolerance = 0.001;
  const Camera camera = perspective_camera("above", {{0.3, 0.1, 6}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 50);
  const Analyzer analyzer(
      floors(), {.sides = SidesPolicy::both, .reflection = reflection, .mirror_faces = std::move(mirror_faces)});
  return analyzer.view(camera, {lamp});
}

std::vector<double> reflecting_areas(const View& view) {
  std::vector<double> areas(view.mesh().face_count(), 0);
  for (const LabelledTriangle& t : view.labelled.triangles) {
    const auto corner = [&](std::size_t i) { return view.labelled.vertices[t.corners[i].index()]; };
    if (t.reflecting != 0) areas[t.face.index()] += 0.5 * norm((corner(1) - corner(0)).cross(corner(2) - corner(0)));
  }
  return areas;
}

void check_mode(ReflectionMode mode) {
  CAPTURE(to_string(mode));
  std::vector<std::uint8_t> left_only(17, 0);
  std::fill_n(left_only.begin(), 8, std::uint8_t{1});
  const View some = viewed(mode, left_only);
  const std::vector<double> all = reflecting_areas(viewed(mode, {}));
  const std::vector<double> left = reflecting_areas(some);
  double left_area = 0;
  double right_area = 0;
  for (std::size_t f = 0; f < 8; ++f) {
    CHECK(left[f] == doctest::Approx(all[f]).epsilon(mode == ReflectionMode::smooth ? 0.05 : 1e-12));
    left_area += left[f];
    right_area += all[f + 8];
  }
  for (std::size_t f = 8; f < 17; ++f) CHECK(left[f] == 0);
  CHECK(left_area > 0.1);
  CHECK(right_area > 0.1);
  CHECK(lattice::joined(lattice::complaints_of_stages(some)) == "");
  CHECK(reflecting_areas(viewed(mode, std::vector<std::uint8_t>(17, 1))) == all);
  CHECK(reflecting_areas(viewed(mode, std::vector<std::uint8_t>(17, 0))) == std::vector<double>(17, 0));
}

}  // namespace

TEST_CASE("only faces that mirror reflect, as they did") {
  for (const ReflectionMode mode : {ReflectionMode::exact, ReflectionMode::triangles, ReflectionMode::smooth})
    check_mode(mode);
}

}  // namespace sightline::tests::mirror_faces_test
