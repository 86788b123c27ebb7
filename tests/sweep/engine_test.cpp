// The fast engine gives what the sweep of everything gives, to the last bit, however fine its cells and however many
// its bands are.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/numbers/parallel.h"
#include "oracle/judging/engine_comparison.h"
#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_scenes.h"
#include "oracle/scenes/random_scenes.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"
#include "tests/tools/random_surfaces.h"
#include "tests/tools/unrounded_scenes.h"

namespace sightline::tests::engine_test {
using namespace lattice;

namespace {

FastOptions options_of(std::uint64_t seed) {
  constexpr std::array<std::size_t, 4> bands{1, 2, 7, 64};
  return {static_cast<int>(seed % 8), bands[seed / 8 % bands.size()]};
}

void report(const RandomScene& scene, const FastOptions& options) {
  const auto differs = [&options](const RandomScene& s) {
    const CutMesh mesh = cut(mesh_of(s));
    EngineTally tally;
    return !engine_differences(project(mesh, s.camera, s.sides), {options}, tally).empty();
  };
  const RandomScene small = reduced(scene, differs);
  const CutMesh mesh = cut(mesh_of(small));
  EngineTally tally;
  FAIL_CHECK(engine_differences(project(mesh, small.camera, small.sides), {options}, tally), to_text(small));
}

void check_random_scenes(RandomScene (*scene_of)(std::uint64_t), std::uint64_t scenes, EngineTally& tally) {
  int failures = 0;
  for (std::uint64_t seed = 1; seed <= scenes && failures < 3; ++seed) {
    const RandomScene scene = scene_of(seed);
    const CutMesh mesh = cut(mesh_of(scene));
    const FastOptions options = options_of(seed);
    if (engine_differences(project(mesh, scene.camera, scene.sides), {options}, tally).empty()) continue;
    ++failures;
    report(scene, options);
  }
}

// The camera sees 20 units of it, around a place.
ProjectedScene seen_from_above(const Mesh& mesh, double x, double y) {
  ViewPoint view;
  view.eye = {x, y, 9};
  view.target = {x, y, 0};
  return project(mesh, orthographic_camera("above", view, 20), Sides::both);
}

}  // namespace

TEST_CASE("engines: random scenes") {
  EngineTally tally;
  check_random_scenes(random_scene, scene_count(10000), tally);
  CHECK(tally.points > 0);
}

TEST_CASE("engines: random scenes whose faces pass through each other") {
  EngineTally tally;
  check_random_scenes(crossing_scene, scene_count(3000), tally);
  CHECK(tally.points > 0);
}

// Nothing is rounded, and nothing cut: facets pass through each other.
TEST_CASE("engines without rounding: random scenes, and such whose faces pass through each other") {
  EngineTally tally;
  for (std::uint64_t seed = 1; seed <= scene_count(500); ++seed) {
    CAPTURE(seed);
    const RandomScene scene = seed % 2 == 0 ? random_scene(seed) : crossing_scene(seed);
    for (const tests::Moved how : tests::every_move) {
      CAPTURE(static_cast<int>(how));
      const ProjectedScene projected =
          project(uncrossed(tests::moved(scene, how)), scene.camera, scene.sides, {Arithmetic::unrounded});
      CHECK(engine_differences(projected, {options_of(seed)}, tally) == "");
    }
  }
  CHECK(tally.points > 0);
}

// Its ends are on two sides of the window, a last bit from the corner; on the grid both are the corner.
TEST_CASE("engines without rounding: an edge that cuts a corner off the window is not on its border") {
  EngineTally tally;
  for (const std::uint64_t seed : {2794U, 3994U, 5859U}) {
    CAPTURE(seed);
    const RandomScene scene = seed % 2 == 0 ? random_scene(seed) : crossing_scene(seed);
    const Mesh mesh = tests::moved(scene, tests::Moved::by_last_bits);
    const ProjectedScene projected = project(uncrossed(mesh), scene.camera, scene.sides, {Arithmetic::unrounded});
    CHECK(engine_differences(projected, {options_of(seed), {3, 1}, {9, 1}}, tally) == "");
  }
}

// On the grid it touches other cells than where it is.
TEST_CASE("engines without rounding: an edge that passes a cell's corner by less than a spacing") {
  EngineTally tally;
  for (const std::uint64_t seed : {1622U, 2114U, 2208U}) {
    CAPTURE(seed);
    const Mesh mesh = tests::moved(random_scene(seed), tests::Moved::by_parts_of_spacings);
    const RandomScene scene = random_scene(seed);
    const ProjectedScene projected = project(uncrossed(mesh), scene.camera, scene.sides, {Arithmetic::unrounded});
    CHECK(engine_differences(projected, {options_of(seed), {static_cast<int>(seed % 8), 7}}, tally) == "");
  }
}

TEST_CASE("engines without rounding: random surfaces") {
  EngineTally tally;
  for (std::uint64_t seed = 1; seed <= scene_count(1000); ++seed) {
    CAPTURE(seed);
    const tests::RandomSurfaces surfaces = tests::random_surfaces(seed);
    const ProjectedScene scene =
        project(uncrossed(surfaces.mesh), surfaces.camera, Sides::both, {Arithmetic::unrounded});
    CHECK(engine_differences(scene, {options_of(seed)}, tally) == "");
  }
  MESSAGE(tally.swept << " of " << tally.points << " sweep points swept");
  CHECK(5 * tally.swept < 4 * tally.points);
}

// Four fifths of the points are swept at most: facets that are seen whole, and facets behind covers, are there.
TEST_CASE("engines: random surfaces") {
  EngineTally tally;
  for (std::uint64_t seed = 1; seed <= scene_count(1000); ++seed) {
    CAPTURE(seed);
    const tests::RandomSurfaces surfaces = tests::random_surfaces(seed);
    const CutMesh mesh = cut(surfaces.mesh);
    const ProjectedScene scene = project(mesh, surfaces.camera, Sides::both);
    CHECK(engine_differences(scene, {options_of(seed)}, tally) == "");
  }
  MESSAGE(tally.swept << " of " << tally.points << " sweep points swept");
  CHECK(5 * tally.swept < 4 * tally.points);
}

// A band across two walls is cut along common lines; one of its pieces is hidden, and what is seen of another ends on
// its edge.
TEST_CASE("engines: an edge is split for a hidden piece of a face, too") {
  const CutMesh mesh = cut(tests::mesh_of({{{0, 5, -1}, {-2, 5, -3}, {-3, 3, 6}},
                                           {{4, 3, 16}, {20, 3, -4}, {-6, 6, -14}, {-22, 6, 6}},
                                           {{4, 3, 18}, {-18, 3, 10}, {-6, 6, -16}, {16, 6, -8}},
                                           {{4, 6, 18}, {-18, 6, 10}, {-6, 3, -16}, {16, 3, -8}},
                                           {{-7, 3, 2}, {-2, 3, -3}, {-3, 6, 6}}}));
  ViewPoint view;
  view.eye = {-2, -10, 1};
  view.target = {-2, 3, 1};
  view.up = {0, 0, -1};
  EngineTally tally;
  for (const double height : {16, 4096}) {
    const ProjectedScene scene = project(mesh, orthographic_camera("along y", view, height), Sides::both);
    CHECK(engine_differences(scene, {{0, 1}, {1, 7}, {9, 1}, {10, 1}, {11, 1}}, tally) == "");
  }
}

// A hook has a long end that is hidden: first by a face that the end that is seen comes near, then by one that it does
// not.
TEST_CASE("engines: a face whose hidden end is covered far from the end that is seen") {
  const Mesh mesh = tests::mesh_of({{{-6, -3, 0},
                                     {0.5, -3.2, 0},
                                     {8, -3, 0},
                                     {8, -2, 0},
                                     {0.5, -2.2, 0},
                                     {-5, -2, 0},
                                     {-5, 6, 0},
                                     {4, 6, 0},
                                     {4, 7, 0},
                                     {-6, 7, 0}},
                                    {{-9, -6, 2}, {2, -6, 2}, {2, 0, 2}, {-9, 0, 2}},
                                    {{-1, -6, 3}, {9.5, -6, 3}, {9.5, 0, 3}, {-1, 0, 3}}});
  const ProjectedScene scene = seen_from_above(mesh, 0, 0);
  EngineTally tally;
  CHECK(engine_differences(scene, {{3, 1}, {5, 7}, {6, 64}}, tally) == "");
}

TEST_CASE("engines: in the middle of a sheet of squares, three of them are one face") {
  std::vector<tests::Corners> faces{
      {{7, 7, 0}, {8, 7, 0}, {9, 7, 0}, {9, 8, 0}, {8, 8, 0}, {8, 9, 0}, {7, 9, 0}, {7, 8, 0}}};
  for (int i = 0; i < 16 * 16; ++i) {
    const double x = i % 16;
    const double y = i / 16;
    if ((y == 7 && (x == 7 || x == 8)) || (y == 8 && x == 7)) continue;
    faces.push_back({{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}});
  }
  const Mesh mesh = tests::mesh_of(faces);
  REQUIRE(mesh.facet_count() > mesh.face_count());
  const ProjectedScene scene = seen_from_above(mesh, 8, 8);
  EngineTally tally;
  CHECK(engine_differences(scene, {{4, 1}, {5, 1}, {6, 7}}, tally) == "");
  CHECK(tally.swept < tally.points);
}

// Where facets pass through each other, the sweep may call the wrong one topmost; both engines call the same.
TEST_CASE("engines: faces that pass through each other, not cut along their common lines") {
  EngineTally tally;
  for (std::uint64_t seed = 1; seed <= scene_count(1000); ++seed) {
    CAPTURE(seed);
    const RandomScene crossing = crossing_scene(seed);
    const Mesh few = mesh_of(crossing);
    CHECK(engine_differences(project(few, crossing.camera, crossing.sides), {options_of(seed)}, tally) == "");
    const tests::RandomSurfaces surfaces = tests::random_surfaces(seed);
    const ProjectedScene scene = project(surfaces.mesh, surfaces.camera, Sides::both);
    CHECK(engine_differences(scene, {options_of(seed)}, tally) == "");
  }
  CHECK(4 * tally.swept < 3 * tally.points);
}

// A sheet of squares in waves is over another one. Where it hides itself and at its border facets are open, else plain.
TEST_CASE("engines: more points than a thread takes in a row") {
  constexpr int squares = 100;
  std::vector<tests::Corners> faces;
  for (int i = 0; i < 2 * squares * squares; ++i) {
    const int x = i % squares;
    const int y = i / squares % squares;
    const auto corner = [&](int u, int v) {
      return Point3{static_cast<double>(u), static_cast<double>(v),
                    3 * std::sin(0.2 * u + 0.1 * v) - (i < squares * squares ? 0.0 : 9.0)};
    };
    faces.push_back({corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)});
    faces.push_back({corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)});
  }
  const Mesh mesh = tests::mesh_of(faces);
  ViewPoint view;
  view.eye = {40, -40, 27};
  view.target = {50, 50, 0};
  view.up = {0, 0, 1};
  const ProjectedScene scene = project(mesh, perspective_camera("along the sheet", view, 60), Sides::both);
  REQUIRE(scene.points.size() > items_per_range);
  EngineTally tally;
  CHECK(engine_differences(scene, {{7, 1}, {7, 7}}, tally) == "");
  CHECK(2 * tally.swept < tally.points);
}

TEST_CASE("engines: surfaces that overlap only because their image is rounded") {
  EngineTally tally;
  std::uint64_t without_order = 0;
  const std::uint64_t scenes = scene_count(2000);
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    CAPTURE(seed);
    const tests::RandomSurfaces surfaces = tests::crowded_surfaces(seed);
    const CutMesh mesh = cut(surfaces.mesh);
    const Precision precision{Arithmetic::exact, 8 + static_cast<int>(seed % 5)};
    const ProjectedScene scene = project(mesh, surfaces.camera, Sides::both, precision);
    CHECK(engine_differences(scene, {options_of(seed)}, tally) == "");
    without_order += plain_sweep(scene).statistics.depth_is_transitive ? 0 : 1;
  }
  MESSAGE(tally.swept << " of " << tally.points << " sweep points swept; no order of depth somewhere in "
                      << without_order << " of " << scenes << " scenes");
  CHECK(16 * tally.swept < 15 * tally.points);
  CHECK(8 * without_order > scenes);
}

// Faces around a vertex go round it twice, and the second time round they rise through those of the first. The mesh is
// not cut: its faces meet along edges of their own.
TEST_CASE("engines: a sheet that winds twice around a vertex covers a cell twice") {
  constexpr std::size_t spokes = 24;
  std::vector<Point3> vertices{{0, 0, 0}};
  for (std::size_t i = 0; i < spokes; ++i) {
    const double angle = 4 * std::numbers::pi * static_cast<double>(i) / spokes;
    const bool is_seam = i == 0 || i == spokes / 2;
    for (int ring = 1; ring <= 2; ++ring) {
      const double r = ring + (i >= spokes / 2 ? 0.5 : 0);
      vertices.push_back(is_seam ? Point3{r, 0, 0}
                                 : Point3{r * std::cos(angle), r * std::sin(angle), 0.5 * r * std::sin(angle / 2)});
    }
  }
  PolygonList faces;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    faces.push_back(std::array{VertexId(a), VertexId(b), VertexId(c)});
  };
  for (std::size_t i = 0; i < spokes; ++i) {
    const std::size_t here = 1 + 2 * i;
    const std::size_t next = 1 + 2 * ((i + 1) % spokes);
    add(0, here, next);
    add(here, here + 1, next + 1);
    add(here, next + 1, next);
  }
  const CutMesh mesh = uncrossed(build_mesh(std::move(vertices), std::move(faces)));
  const Camera camera = orthographic_camera("top", {.eye = {0.13, 0.21, 100}, .target = {0.13, 0.21, 0}}, 9);
  EngineTally tally;
  for (const int level : {2, 3, 4, 5, 6, 7})
    CHECK(engine_differences(project(mesh, camera, Sides::both), {{level, 2}}, tally) == "");
}

}  // namespace sightline::tests::engine_test
