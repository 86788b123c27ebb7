// A face and its turned copy are a front and a back: what is seen of either does not depend on which comes first.
#include <doctest/doctest.h>

#include <map>
#include <random>

#include "sightline/analyzer.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::turned_copy_test {
namespace {

const Corners square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
const Corners angle{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 0, 0}, {-1, 1, 0}};
const Corners warped{{-1, -1, 0}, {1, -1, 0.25}, {1, 1, 0}, {-1, 1, 0.5}};
const Corners behind{{-3, -3, -1}, {3, -3, -1}, {3, 3, -1}, {-3, 3, -1}};
const Corners above{{-20, -20, 9}, {20, -20, 9}, {20, 20, 9}, {-20, 20, 9}};
const Corners below{{-20, -20, -9}, {20, -20, -9}, {20, 20, -9}, {-20, 20, -9}};

Corners turned(Corners corners) {
  std::ranges::reverse(corners);
  return corners;
}

Camera camera_at(const Point3& eye) {
  ViewPoint from;
  from.eye = eye;
  return perspective_camera("camera", from, 60);
}

// In the image: what is visible of each face, and what of it reflects a panel.
std::vector<std::array<double, 2>> areas(const std::vector<Corners>& faces, const Camera& camera, SidesPolicy sides) {
  AnalysisOptions options;
  options.sides = sides;
  const Analyzer analyzer(mesh_of(faces), options);
  const View view = analyzer.view(camera, {{"above", above}, {"below", below}});
  std::vector<std::array<double, 2>> result(faces.size());
  for (const VisiblePolygon& polygon : view.polygons.polygons) result[polygon.face.index()][0] += polygon.area;
  for (const PanelReflection& panel : view.reflections.panels) {
    for (const VisiblePolygon& polygon : panel.polygons.polygons) result[polygon.face.index()][1] += polygon.area;
  }
  return result;
}

}  // namespace

TEST_CASE("neither areas nor reflections depend on which of both comes first") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-3, 3);
  double seen = 0;
  double reflecting = 0;
  for (const Corners& face : {square, angle, warped}) {
    for (const SidesPolicy sides : {SidesPolicy::front, SidesPolicy::both, SidesPolicy::automatic}) {
      for (int i = 0; i < 10; ++i) {
        CAPTURE(i);
        const Camera camera = camera_at({place(random), place(random), i % 2 == 0 ? 4.0 : -4.0});
        const auto one = areas({face, turned(face), behind}, camera, sides);
        const auto other = areas({turned(face), face, behind}, camera, sides);
        CHECK(one[0] == other[1]);
        CHECK(one[1] == other[0]);
        CHECK(one[2] == other[2]);
        seen += one[0][0];
        reflecting += one[0][1];
      }
    }
  }
  CHECK(seen > 1);
  CHECK(reflecting > 0.01);
}

TEST_CASE("of both the one that looks at the eye is seen, and hides") {
  for (const SidesPolicy sides : {SidesPolicy::front, SidesPolicy::both}) {
    const auto from_front = areas({turned(square), square, behind}, camera_at({0, 0, 4}), sides);
    CHECK(from_front[0][0] == 0);
    CHECK(from_front[1][0] > 0.5);
    const auto alone = areas({square, behind}, camera_at({0, 0, 4}), sides);
    CHECK(from_front[1] == alone[0]);
    CHECK(from_front[2] == alone[1]);
  }
}

TEST_CASE("copies with the same winding repeat, wherever they begin") {
  const Corners again{square[2], square[3], square[0], square[1]};
  const Mesh mesh = mesh_of({square, again, turned(square), {square[1], square[0], square[3], square[2]}});
  REQUIRE(mesh.defects.size() == 2);
  CHECK(mesh.defects[0].face == FaceId(1));
  CHECK(mesh.defects[1].face == FaceId(3));
}

}  // namespace sightline::tests::turned_copy_test
