// What several cameras see together, and mirror together, is held against areas found by hand.
#include "coverage/coverage.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "oracle/judging/judge.h"
#include "tests/reflect/mirror_outcome.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::coverage_test {
namespace {

// Parallel rays go straight down: the camera sees the square of this half width around (x, y).
Camera over(double x, double y, double half_width) {
  Camera camera;
  camera.name = "over";
  camera.projection = Projection::orthographic;
  camera.right = {1 / half_width, 0, 0};
  camera.up = {0, 1 / half_width, 0};
  camera.forward = {0, 0, -1};
  camera.origin = {x, y, 64};
  camera.eye = {{0, 0, 1}, 0};
  return camera;
}

Coverage covered(const std::vector<Corners>& surface, const std::vector<Camera>& cameras,
                 const std::vector<Panel>& panels = {}) {
  const CutMesh mesh = lattice::cut(mesh_of(surface));
  const MirrorWorld world = mirror_world(mesh, panels);
  std::vector<SeenPart> seen;
  for (const Camera& camera : cameras) {
    const View view = analyzed(world, camera);
    CHECK(lattice::joined(lattice::complaints_of_stages(view)) == "");
    seen.push_back(seen_part(view.labelled));
  }
  return cover(mesh, seen, panels.size());
}

double visible_area(const std::vector<Corners>& surface, const std::vector<Camera>& cameras) {
  return covered(surface, cameras).together.visible;
}

bool is_close(double a, double b) { return std::fabs(a - b) <= 1e-10; }

const Corners square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
const Camera lower_left = over(1, 1, 1);  // [0, 2] x [0, 2]
const Camera middle = over(2, 2, 1);      // [1, 3] x [1, 3]

}  // namespace

TEST_CASE("two cameras that see overlapping parts of one square") {
  const Coverage coverage = covered({square}, {lower_left, middle});
  CHECK(coverage.area == 16);
  REQUIRE(coverage.cameras.size() == 2);
  CHECK(is_close(coverage.cameras[0].visible, 4));
  CHECK(is_close(coverage.cameras[1].visible, 4));
  CHECK(is_close(coverage.together.visible, 7));
  CHECK(coverage.together.any_panel == 0);
  REQUIRE(coverage.faces.size() == 1);
  CHECK(coverage.faces[0].area == 16);
  CHECK(coverage.faces[0].visible == coverage.together.visible);
}

TEST_CASE("parts that are nested, apart, side by side, equal, or all of it") {
  CHECK(is_close(visible_area({square}, {lower_left, over(1, 1, 0.5)}), 4));
  CHECK(is_close(visible_area({square}, {lower_left, over(4, 4, 1)}), 5));
  CHECK(is_close(visible_area({square}, {lower_left, over(3, 1, 1)}), 8));
  CHECK(is_close(visible_area({square}, {lower_left, lower_left, lower_left}), 4));
  CHECK(visible_area({square}, {lower_left, over(2, 2, 3)}) == 16);
  CHECK(is_close(visible_area({square}, {over(0, 2, 2.5), over(4, 2, 2.5)}), 16));
  CHECK(visible_area({square}, {over(9, 9, 1), over(-9, 9, 1)}) == 0);
}

TEST_CASE("a surface that is tilted, or all but upright, has its area in space") {
  for (const double slope : {0.75, -2.0, 1024.0}) {
    CAPTURE(slope);
    const Corners tilted{{0, 0, 0}, {4, 0, 4 * slope}, {4, 4, 4 * slope}, {0, 4, 0}};
    const double factor = std::hypot(1, slope);
    CHECK(std::fabs(visible_area({tilted}, {lower_left, middle}) / factor - 7) <= 1e-10);
  }
}

TEST_CASE("a planar face that is not convex is one surface, in several facets") {
  const Corners angle{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}};
  // The cameras see [0, 3] x [0, 2.5] and [0, 2.5] x [1.5, 4], without what lies beyond both of x = 2 and y = 2.
  const Coverage coverage = covered({angle}, {over(1.5, 1, 1.5), over(1, 3, 1.5)});
  CHECK(is_close(coverage.cameras[0].visible, 7));
  CHECK(is_close(coverage.cameras[1].visible, 5.25));
  CHECK(is_close(coverage.together.visible, 7 + 5.25 - 2.25));
}

TEST_CASE("faces that pass through each other, cut along their common line") {
  const Corners floor{{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
  // The wall is above the floor for x from 0 to 1/2, where it hides it.
  const Corners wall{{-0.5, -2, -1}, {0.5, -2, 1}, {0.5, 2, 1}, {-0.5, 2, -1}};
  const Coverage coverage = covered({floor, wall}, {over(0, 0, 1), over(0.5, 0, 1)});
  REQUIRE(coverage.faces.size() == 2);
  CHECK(is_close(coverage.faces[0].visible, 4));  // x from -1 to 0 and from 1/2 to 3/2
  CHECK(is_close(coverage.faces[1].visible, std::sqrt(5.0)));
  CHECK(is_close(coverage.together.visible, 4 + std::sqrt(5.0)));
  CHECK(is_close(coverage.cameras[0].visible, 3 + std::sqrt(5.0)));
}

TEST_CASE("a face that is not planar: the facets are surfaces of their own") {
  const Corners warped{{0, 0, 0}, {4, 0, 0}, {4, 4, 3}, {0, 4, 0}};
  const Coverage whole = covered({warped}, {over(2, 2, 3)});
  CHECK(whole.together.visible == whole.area);
  const Coverage halves = covered({warped}, {over(1, 2, 2), over(4, 2, 2)});
  CHECK(is_close(halves.together.visible, whole.area));
  CHECK(halves.cameras[0].visible < 0.8 * whole.area);
  CHECK(halves.cameras[1].visible < 0.8 * whole.area);
}

TEST_CASE("a skipped face has zeros, and faces keep their numbers") {
  const Corners none{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const Coverage coverage = covered({none, square, none}, {lower_left, middle});
  REQUIRE(coverage.faces.size() == 3);
  CHECK(coverage.faces[0].area == 0);
  CHECK(coverage.faces[0].visible == 0);
  CHECK(is_close(coverage.faces[1].visible, 7));
  CHECK(coverage.faces[2].visible == 0);
}

TEST_CASE("reflections of two panels in two cameras overlap") {
  // A panel's point (x, y, 4) is mirrored halfway to the eye.
  const Corners floor{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}};
  const std::vector<Panel> panels{{"a", {{1, -1, 4}, {3, -1, 4}, {3, 1, 4}, {1, 1, 4}}, Emits::both},
                                  {"b", {{2, -1, 4}, {4, -1, 4}, {4, 1, 4}, {2, 1, 4}}, Emits::both}};
  const Coverage coverage = covered({floor}, {looking_down({-2, 0, 4}), looking_down({-1, 0, 4})}, panels);
  // In x, a is mirrored in [-1/2, 1/2] and [0, 1], b in what a leaves of [0, 1] and [1/2, 3/2]; in y all are in [-1/2, 1/2].
  for (const CoveredAreas& camera : coverage.cameras) {
    CHECK(is_close(camera.visible, 64));
    CHECK(is_close(camera.panels[0], 1));
    CHECK(is_close(camera.panels[1], 0.5));
    CHECK(is_close(camera.any_panel, 1.5));
  }
  CHECK(is_close(coverage.together.visible, 72));
  CHECK(is_close(coverage.together.panels[0], 1.5));
  CHECK(is_close(coverage.together.panels[1], 1));
  CHECK(is_close(coverage.together.any_panel, 2));
  CHECK(coverage.faces[0].reflecting == coverage.together.any_panel);
}

TEST_CASE("a small mirror that shows a panel all over in one camera") {
  const Corners mirror{{-0.25, -0.25, 0}, {0.25, -0.25, 0}, {0.25, 0.25, 0}, {-0.25, 0.25, 0}};
  const std::vector<Panel> panel{{"a", {{1, -1, 4}, {3, -1, 4}, {3, 1, 4}, {1, 1, 4}}, Emits::both}};
  const Coverage coverage = covered({mirror}, {looking_down({-2, 0, 4}), looking_down({-1, 0, 4})}, panel);
  CHECK(coverage.cameras[0].panels[0] == 0.25);
  CHECK(is_close(coverage.cameras[1].panels[0], 0.125));
  CHECK(coverage.together.panels[0] == 0.25);
  CHECK(coverage.together.any_panel == 0.25);
}

TEST_CASE("what is kept of a view: no triangles where a surface is all alike") {
  const Mesh mesh = mesh_of({square, {{9, 0, 0}, {10, 0, 0}, {9, 1, 0}}});
  const auto kept = [&](const Camera& camera) { return seen_part(analyzed(mesh, camera).labelled); };
  const SeenPart whole = kept(over(2, 2, 3));
  REQUIRE(whole.surfaces.size() == 1);
  CHECK(whole.surfaces[0].seen_everywhere);
  CHECK(whole.triangles.empty());
  const SeenPart part = kept(over(6, 0, 4));
  REQUIRE(part.surfaces.size() == 2);
  CHECK_FALSE(part.surfaces[0].seen_everywhere);
  CHECK(part.triangles_of(0).size() == part.triangles.size());
  CHECK(part.triangles_of(1).empty());
}

TEST_CASE("only faces that count are in the sums; each face has its own areas all the same") {
  const CutMesh mesh = lattice::cut(mesh_of({square, {{8, 0, 0}, {10, 0, 0}, {10, 2, 0}, {8, 2, 0}}}));
  std::vector<SeenPart> seen;
  for (const Camera& camera : {over(5, 1, 4), over(9, 1, 1)})
    seen.push_back(seen_part(analyzed(mesh, camera).labelled));
  const Coverage all = cover(mesh, seen, 0);
  const Coverage second = cover(mesh, seen, 0, std::vector<std::uint8_t>{0, 1});
  CHECK(all.area == 20);
  CHECK(second.area == 4);
  CHECK(is_close(second.cameras[0].visible, 2));
  CHECK(is_close(second.cameras[1].visible, 4));
  CHECK(is_close(second.together.visible, 4));
  for (std::size_t f = 0; f < 2; ++f) CHECK(second.faces[f].visible == all.faces[f].visible);
  CHECK(is_close(all.together.visible, 4 + all.faces[0].visible));
  CHECK(all.faces[0].visible > 1);
  const Coverage none = cover(mesh, seen, 0, std::vector<std::uint8_t>{0, 0});
  CHECK(none.area == 0);
  CHECK(none.together.visible == 0);
}

}  // namespace sightline::tests::coverage_test
