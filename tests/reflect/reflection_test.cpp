// What mirrors a panel into the camera is held against areas found by hand.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/reflect/mirror_outcome.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::reflection_test {
namespace {

struct Outcome : tests::MirrorOutcome {
  std::vector<Rational> image_areas;  // per panel, in window units
};

Corners turned(Corners corners) {
  std::ranges::reverse(corners);
  return corners;
}

Outcome reflected(const std::vector<Corners>& surface, const std::vector<Panel>& panels,
                  const Camera& camera = looking_down(mirror_eye)) {
  Outcome outcome{tests::reflected(lattice::cut(mesh_of(surface)), panels, camera), {}};
  for (std::size_t p = 0; p < panels.size(); ++p) outcome.image_areas.push_back(exact_image_area(outcome.view, p));
  return outcome;
}

Outcome reflected(const std::vector<Corners>& surface, const Corners& panel) {
  return reflected(surface, {{"panel", panel, Emits::both}});
}

}  // namespace

TEST_CASE("a flat mirror shows a square panel in its image from the mirror camera") {
  const Outcome outcome = reflected({floor_mirror}, overhead);
  CHECK(outcome.image_areas == std::vector{Rational(1, 16)});
  CHECK(outcome.areas[0] == 1);
  CHECK(outcome.view.reflections.statistics.pyramids == 1);
  CHECK(outcome.view.reflections.statistics.blocked == 0);
  const auto& polygons = outcome.view.reflections.panels[0].polygons;
  REQUIRE(polygons.polygons.size() == 1);
  CHECK(polygons.ring(0).size() == 4);
  CHECK(polygons.polygons[0].face == FaceId(0));
}

TEST_CASE("a panel that ends beyond the mirror is mirrored as far as the mirror reaches") {
  const Outcome outcome = reflected({rectangle(-8, 0.25, -8, 8, 0)}, overhead);
  CHECK(outcome.image_areas == std::vector{Rational(3, 64)});
  CHECK(outcome.areas[0] == 0.75);
}

TEST_CASE("a panel that is not convex, and one with a mirror of two triangles") {
  const Corners angle{{1, -1, 4}, {3, -1, 4}, {3, 0, 4}, {2, 0, 4}, {2, 1, 4}, {1, 1, 4}};
  CHECK(reflected({floor_mirror}, angle).image_areas == std::vector{Rational(3, 64)});
  const std::vector<Corners> halves{{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}}, {{-8, -8, 0}, {8, 8, 0}, {-8, 8, 0}}};
  const Outcome outcome = reflected(halves, overhead);
  CHECK(outcome.image_areas == std::vector{Rational(1, 16)});
  CHECK(outcome.areas[0] == 1);
  CHECK(outcome.view.reflections.panels[0].polygons.polygons.size() == 2);
}

TEST_CASE("a panel shines where its front is, or on both sides") {
  const auto area_of = [](const Corners& corners, Emits emits) {
    return reflected({floor_mirror}, {{"panel", corners, emits}}).areas[0];
  };
  CHECK(area_of(overhead, Emits::both) == 1);
  CHECK(area_of(turned(overhead), Emits::both) == 1);
  CHECK(area_of(overhead, Emits::front) == 0);
  CHECK(area_of(turned(overhead), Emits::front) == 1);
}

TEST_CASE("of a panel that is half below the mirror's plane the upper half is mirrored") {
  // The panel is upright at x = 2, from z = -4 to 4: above the mirror it is mirrored in x from 0 (its top) to 2 (its
  // foot).
  const Corners upright{{2, -1, -4}, {2, 1, -4}, {2, 1, 4}, {2, -1, 4}};
  const Outcome outcome = reflected({floor_mirror}, upright);
  // It shows as a trapezoid: half as wide at x = 0 as at x = 2.
  CHECK(std::fabs(outcome.areas[0] - 2 * (1 + 2) / 2.0) < 1e-9);
  CHECK(std::fabs(outcome.image_areas[0].convert_to<double>() - 3.0 / 16) < 1e-11);
  CHECK(reflected({floor_mirror}, rectangle(1, 3, -1, 1, -4)).areas[0] == 0);
}

TEST_CASE("a tilted panel") {
  // The panel goes from (1, -1, 4) to (3, 1, 12): at height z a point (x, y) is mirrored in -2 + 4 (x + 2) / (z + 4), 4
  // y / (z + 4).
  const Corners tilted{{1, -1, 4}, {1, 1, 4}, {3, 1, 12}, {3, -1, 12}};
  const Outcome outcome = reflected({floor_mirror}, tilted);
  // The corners are mirrored in (-1/2, -+1/2) and (-3/4, -+1/4).
  CHECK(std::fabs(outcome.areas[0] - 0.25 * (1 + 0.5) / 2) < 1e-11);
}

TEST_CASE("a square obstacle casts its shadow") {
  // At z = 2, seen from the mirror camera (-2, 0, -4), a point (x, y) is mirrored in -2 + (x + 2) 2 / 3, y 2 / 3.
  const auto with = [](const Corners& obstacle) { return reflected({floor_mirror, obstacle}, overhead); };
  // It is mirrored in [-1/4, 1/4]^2, but the obstacle itself is seen before the mirror: in x from -2 + 2 (x + 2),
  // beyond.
  const Corners inside = rectangle(0.625, 1.375, -0.375, 0.375, 2);
  const Outcome outcome = with(inside);
  CHECK(std::fabs(outcome.areas[0] - 0.75) < 1e-11);
  CHECK(outcome.view.reflections.statistics.blocked == 1);
  REQUIRE(outcome.view.reflections.panels[0].polygons.polygons.size() == 1);
  CHECK(outcome.view.reflections.panels[0].polygons.polygons[0].ring_count == 2);
  // It is over the panel's edge: mirrored in [-1/4, 3/4] x [-1/4, 1/4].
  CHECK(std::fabs(with(rectangle(0.625, 2.125, -0.375, 0.375, 2)).areas[0] - (1 - 0.75 * 0.5)) < 1e-11);
  // It hides all of it.
  CHECK(with(rectangle(0, 4, -4, 4, 2)).areas[0] == 0);
}

TEST_CASE("an obstacle without a vertex in the pyramid, which the source's test of vertices misses") {
  // A strip goes right across: it is mirrored in [-1/4, 1/4] x [-4, 4].
  const Corners strip = rectangle(0.625, 1.375, -6, 6, 2);
  CHECK(std::fabs(reflected({floor_mirror, strip}, overhead).areas[0] - 0.5) < 1e-11);
  // A triangle holds all of the pyramid, and has no edge in it either.
  const Corners all{{-90, -90, 2}, {90, -90, 2}, {0.5, 90, 2}};
  const Camera below_it = looking_down({-2, 0, 1});
  const Corners panel = rectangle(1, 3, -1, 1, 7);
  CHECK(reflected({floor_mirror}, {{"panel", panel, Emits::both}}, below_it).areas[0] > 0.05);
  CHECK(reflected({floor_mirror, all}, {{"panel", panel, Emits::both}}, below_it).areas[0] == 0);
}

TEST_CASE("obstacles behind the panel, behind the mirror, and in the mirror's plane, hide nothing") {
  for (const Corners& obstacle :
       {rectangle(0, 4, -4, 4, 5), rectangle(-3, 3, -3, 3, -1), rectangle(-8, 8, 8, 9, 0), rectangle(0, 4, -4, 4, 4)}) {
    CAPTURE(obstacle[0].z());
    CHECK(reflected({floor_mirror, obstacle}, overhead).areas[0] == 1);
  }
}

TEST_CASE("an obstacle that stands on the mirror hides what is behind it") {
  // The wall is upright at x = 1/4, from the mirror up to z = 1: it is in the way of rays that do not clear its top,
  // and the camera does not see the mirror behind it.
  const Corners wall{{0.25, -4, 0}, {0.25, 4, 0}, {0.25, 4, 1}, {0.25, -4, 1}};
  const Outcome outcome = reflected({floor_mirror, wall}, overhead);
  // A ray from the mirror camera through (x, 0) has height 4 (0.25 - x) / (x + 2) at x = 1/4: below 1 for x > -1/5.
  // The camera sees the mirror up to x = 1/4.
  CHECK(std::fabs(outcome.areas[0] - (-0.2 + 0.5)) < 1e-9);
}

TEST_CASE("an obstacle that passes through the mirror or through the panel's plane counts with its part between them") {
  const Corners from_below{{0.25, -4, -3}, {0.25, 4, -3}, {0.25, 4, 1}, {0.25, -4, 1}};
  CHECK(std::fabs(reflected({floor_mirror, from_below}, overhead).areas[0] - 0.3) < 1e-9);
  // The obstacle is upright at x = 2, from z = 2 to beyond the panel: its part below the panel is mirrored in x from 0
  // to 2/3.
  const Corners through{{2, -4, 2}, {2, 4, 2}, {2, 4, 9}, {2, -4, 9}};
  CHECK(std::fabs(reflected({floor_mirror, through}, overhead).areas[0] - 0.5) < 1e-9);
}

TEST_CASE("a camera in the mirror's plane sees nothing in it") {
  Camera level = looking_down({-12, 0, 0});
  level.right = {0, -1, 0};
  level.up = {0, 0, 1};
  level.forward = {1, 0, 0};
  const Outcome outcome = reflected({floor_mirror}, {{"panel", overhead, Emits::both}}, level);
  CHECK(outcome.areas[0] == 0);
  CHECK(outcome.image_areas[0] == 0);
}

TEST_CASE("a panel seen edge-on in the mirror has no area") {
  // The panel is in a plane through the mirror camera (-2, 0, -4).
  const Corners edge_on{{0, -1, 0.5}, {0, 1, 0.5}, {2, 2, 5}, {2, -2, 5}};
  CHECK(reflected({floor_mirror}, edge_on).areas[0] == 0);
}

TEST_CASE("of two panels the one before hides the other, with its dark side too") {
  const Corners before = rectangle(0.625, 2.125, -0.375, 0.375, 2);  // mirrored in [-1/4, 3/4] x [-1/4, 1/4]
  const auto areas = [&](Emits emits) {
    return reflected({floor_mirror}, {{"far", overhead, Emits::both}, {"near", before, emits}}).areas;
  };
  const std::vector<double> both = areas(Emits::both);
  CHECK(std::fabs(both[0] - (1 - 0.75 * 0.5)) < 1e-11);
  CHECK(std::fabs(both[1] - 0.5) < 1e-11);
  const std::vector<double> dark = areas(Emits::front);
  CHECK(std::fabs(dark[0] - (1 - 0.75 * 0.5)) < 1e-11);
  CHECK(dark[1] == 0);
}

TEST_CASE(
    "of two panels in one plane the first one is in front, in mirrors of both kinds, whichever way the other is "
    "turned") {
  Corners other = rectangle(2, 4, -1, 1, 4);
  for (const bool is_turned : {false, true}) {
    CAPTURE(is_turned);
    if (is_turned) std::ranges::reverse(other);
    const std::vector<Panel> panels{{"a", overhead, Emits::both}, {"b", other, Emits::both}};
    const Outcome outcome = reflected({floor_mirror}, panels);
    CHECK(outcome.areas == std::vector<double>{1, 0.5});
    const MirrorOutcome bent = reflected(AnyMesh(mesh_of({floor_mirror})), panels, looking_down(mirror_eye),
                                         {ReflectionMode::smooth, MirrorNormals::vertex, 1e-3});
    CHECK(bent.areas[0] == doctest::Approx(1).epsilon(1e-9));
    CHECK(bent.areas[1] == doctest::Approx(0.5).epsilon(1e-9));
    for (const LabelledTriangle& t : outcome.view.labelled.triangles) CHECK(t.reflecting != 3);
  }
}

// Whether a camera is shown the backs of faces is no matter of light.
TEST_CASE("faces whose backs are not shown block mirrored rays, in mirrors of both kinds") {
  Corners facing_down = rectangle(0.625, 2.125, -0.375, 0.375, 2);
  std::ranges::reverse(facing_down);
  const Mesh mesh = mesh_of({floor_mirror, facing_down});
  for (const ReflectionMode mode : {ReflectionMode::exact, ReflectionMode::smooth}) {
    CAPTURE(static_cast<int>(mode));
    const MirrorWorld world =
        mirror_world(AnyMesh(mesh), {{"overhead", overhead, Emits::both}}, {mode, MirrorNormals::vertex, 1e-3});
    const View view = Analyzer(world.surface, {.sides = SidesPolicy::front, .reflection = world.options})
                          .view(looking_down(mirror_eye), world);
    double area = 0;
    for (const LabelledTriangle& t : view.labelled.triangles)
      area += t.reflecting != 0 ? tests::area(view.labelled, t) : 0;
    // As in "of two panels", where the obstacle is a panel: but nothing of the obstacle is seen itself.
    CHECK(std::fabs(area - (1 - 0.75 * 0.5)) < 1e-9);
  }
}

TEST_CASE("a panel around the camera: the camera looks at its own mirror image") {
  const Outcome outcome = reflected({floor_mirror}, rectangle(-4, 0, -2, 2, 4));
  CHECK(outcome.areas[0] == 4);
  CHECK(outcome.image_areas[0] == Rational(1, 4));
}

TEST_CASE("parallel rays") {
  Camera camera = looking_down({0, 0, 4});
  camera.projection = Projection::orthographic;
  camera.right = {0.25, 0, 0};
  camera.up = {0, 0.25, 0};
  camera.eye = {{0, 0, 1}, 0};
  const Outcome straight = reflected({floor_mirror}, {{"panel", overhead, Emits::both}}, camera);
  CHECK(straight.areas[0] == 4);
  CHECK(straight.image_areas[0] == Rational(1, 4));
  // A mirror is at 45 degrees, and a panel beside it: z from 1 to 2 is mirrored in x from -2 to -1.
  const Corners slope{{-3, -3, 3}, {3, -3, -3}, {3, 3, -3}, {-3, 3, 3}};
  const Corners beside{{4, -1, 1}, {4, 1, 1}, {4, 1, 2}, {4, -1, 2}};
  const Outcome outcome = reflected({slope}, {{"panel", beside, Emits::both}}, camera);
  CHECK(outcome.image_areas[0] == Rational(1, 8));
  CHECK(std::fabs(outcome.areas[0] - 2 * std::sqrt(2.0)) < 1e-12);
}

TEST_CASE("panels that are no polygons are refused with their names") {
  const Mesh mesh = mesh_of({floor_mirror});
  struct Wrong {
    Corners corners;
    const char* cause;
  };
  const std::vector<Wrong> wrong{
      {{{0, 0, 1}, {1, 0, 1}}, "too few corners"},
      {{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}, "zero area"},
      {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1.5}, {0, 1, 1}}, "not in one plane"},
      {{{0, 0, 1}, {1, 1, 1}, {1, 0, 1}, {0, 1, 1}}, "self-crossing"},
  };
  for (const Wrong& panel : wrong) {
    CAPTURE(panel.cause);
    const auto make = [&] { return mirror_world(mesh, {{"lamp", panel.corners, Emits::both}}); };
    CHECK_THROWS_WITH_AS((void)make(), doctest::Contains("panel \"lamp\": "), PanelError);
    CHECK_THROWS_WITH_AS((void)make(), doctest::Contains(panel.cause), PanelError);
    CHECK(says_what_to_do(message_of<PanelError>([&] { static_cast<void>(make()); })));
  }
}

}  // namespace sightline::tests::reflection_test
