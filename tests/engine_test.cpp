// The fast engine gives what the sweep of everything gives, to the last bit, however fine its cells and however many its
// bands are.
#include <doctest/doctest.h>

#include <array>

#include "tests/engine_comparison.h"
#include "tests/oracle/crossing_scenes.h"
#include "tests/oracle/judge.h"
#include "tests/oracle/random_scenes.h"
#include "tests/random_surfaces.h"

namespace sightline::oracle {
namespace {

using testing::engine_differences;
using testing::EngineTally;

FastOptions options_of(std::uint64_t seed) {
  constexpr std::array<std::size_t, 4> bands{1, 2, 7, 64};
  return {static_cast<int>(seed % 8), bands[seed / 8 % bands.size()]};
}

void report(const RandomScene& scene, const FastOptions& options) {
  const auto differs = [&options](const RandomScene& s) {
    const Mesh mesh = cut(mesh_of(s));
    EngineTally tally;
    return !engine_differences(mesh, project(mesh, s.camera, s.sides), {options}, tally).empty();
  };
  const RandomScene small = reduced(scene, differs);
  const Mesh mesh = cut(mesh_of(small));
  EngineTally tally;
  FAIL_CHECK(engine_differences(mesh, project(mesh, small.camera, small.sides), {options}, tally), to_text(small));
}

void check_random_scenes(RandomScene (*scene_of)(std::uint64_t), std::uint64_t scenes, EngineTally& tally) {
  int failures = 0;
  for (std::uint64_t seed = 1; seed <= scenes && failures < 3; ++seed) {
    const RandomScene scene = scene_of(seed);
    const Mesh mesh = cut(mesh_of(scene));
    const FastOptions options = options_of(seed);
    if (engine_differences(mesh, project(mesh, scene.camera, scene.sides), {options}, tally).empty()) continue;
    ++failures;
    report(scene, options);
  }
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

// Four fifths of the points are swept at most: patches and facets behind covers are there.
TEST_CASE("engines: random surfaces") {
  EngineTally tally;
  for (std::uint64_t seed = 1; seed <= scene_count(1000); ++seed) {
    CAPTURE(seed);
    const testing::RandomSurfaces surfaces = testing::random_surfaces(seed);
    const Mesh mesh = cut(surfaces.mesh);
    const ProjectedScene scene = project(mesh, surfaces.camera, Sides::both);
    CHECK(engine_differences(mesh, scene, {options_of(seed)}, tally) == "");
  }
  MESSAGE(tally.swept << " of " << tally.points << " sweep points swept");
  CHECK(5 * tally.swept < 4 * tally.points);
}

// Where facets pass through each other, the sweep may call the wrong one topmost; both engines call the same.
TEST_CASE("engines: faces that pass through each other, not cut along their common lines") {
  EngineTally tally;
  for (std::uint64_t seed = 1; seed <= scene_count(1000); ++seed) {
    CAPTURE(seed);
    const RandomScene crossing = crossing_scene(seed);
    const Mesh few = mesh_of(crossing);
    CHECK(engine_differences(few, project(few, crossing.camera, crossing.sides), {options_of(seed)}, tally) == "");
    const testing::RandomSurfaces surfaces = testing::random_surfaces(seed);
    const ProjectedScene scene = project(surfaces.mesh, surfaces.camera, Sides::both);
    CHECK(engine_differences(surfaces.mesh, scene, {options_of(seed)}, tally) == "");
  }
  CHECK(4 * tally.swept < 3 * tally.points);
}

TEST_CASE("engines: surfaces that overlap only because their image is rounded") {
  EngineTally tally;
  std::uint64_t without_order = 0;
  const std::uint64_t scenes = scene_count(2000);
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    CAPTURE(seed);
    const testing::RandomSurfaces surfaces = testing::crowded_surfaces(seed);
    const Mesh mesh = cut(surfaces.mesh);
    const Precision precision{Arithmetic::exact, 8 + static_cast<int>(seed % 5)};
    const ProjectedScene scene = project(mesh, surfaces.camera, Sides::both, precision);
    CHECK(engine_differences(mesh, scene, {options_of(seed)}, tally) == "");
    without_order += sweep(mesh, scene).statistics.depth_is_transitive ? 0 : 1;
  }
  MESSAGE(tally.swept << " of " << tally.points << " sweep points swept; no order of depth somewhere in "
                      << without_order << " of " << scenes << " scenes");
  CHECK(8 * tally.swept < 7 * tally.points);
  CHECK(4 * without_order > scenes);
}

}  // namespace sightline::oracle
