// This tests Koucky's test per triangle, and what it misses.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/reflect/mirror_outcome.h"

namespace sightline::tests::reflecting_triangles_test {
namespace {

constexpr ReflectionOptions by_faces{ReflectionMode::triangles, MirrorNormals::face, 1e-3};
constexpr ReflectionOptions by_vertices{ReflectionMode::triangles, MirrorNormals::vertex, 1e-3};

// Triangles cover [-8, 8]^2 at z = 0, two to a square with sides of 1/4 around the origin, where panels are mirrored.
std::vector<Corners> tiled_floor() {
  std::vector<Corners> tiles{rectangle(-8, -1, -8, 8, 0), rectangle(1, 8, -8, 8, 0), rectangle(-1, 1, -8, -1, 0),
                             rectangle(-1, 1, 1, 8, 0)};
  for (int j = -4; j < 4; ++j) {
    for (int i = -4; i < 4; ++i) {
      const Corners square = rectangle(i / 4.0, (i + 1) / 4.0, j / 4.0, (j + 1) / 4.0, 0);
      tiles.push_back({square[0], square[1], square[2]});
      tiles.push_back({square[0], square[2], square[3]});
    }
  }
  return tiles;
}

MirrorOutcome on_floor(const std::vector<Corners>& obstacles, const Panel& panel, const ReflectionOptions& options) {
  std::vector<Corners> surface = tiled_floor();
  surface.insert(surface.end(), obstacles.begin(), obstacles.end());
  return reflected(lattice::cut(mesh_of(surface)), {panel}, looking_down(mirror_eye), options);
}

std::size_t marked(const View& view) {
  return static_cast<std::size_t>(
      std::ranges::count_if(view.labelled.triangles, [](const LabelledTriangle& t) { return t.reflecting != 0; }));
}

// The panel is overhead, a hair larger: it is mirrored in a square with sides of 1, which has 16 tiles' squares inside.
const Corners above = rectangle(1 - 0x1p-10, 3 + 0x1p-10, -1 - 0x1p-10, 1 + 0x1p-10, 4);

}  // namespace

TEST_CASE("triangles whose corners all mirror the panel reflect, and those that do in part do not") {
  for (const ReflectionOptions& options : {by_faces, by_vertices}) {
    CHECK(on_floor({}, {"above", above, Emits::both}, options).areas[0] == 1);
    CHECK(marked(on_floor({}, {"above", above, Emits::both}, options).view) == 32);
    // It is mirrored in [-3/8, 3/8]^2: four squares are inside, the others not wholly.
    const Corners smaller = rectangle(1.25, 2.75, -0.75, 0.75, 4);
    CHECK(on_floor({}, {"smaller", smaller, Emits::both}, options).areas[0] == 0.25);
    CHECK(std::fabs(on_floor({}, {"smaller", smaller, Emits::both}, {}).areas[0] - 0.5625) < 1e-9);
  }
}

TEST_CASE("a panel whose front is turned away, or that is below the mirror, is not met") {
  Corners downwards = above;
  std::ranges::reverse(downwards);
  CHECK(on_floor({}, {"above", above, Emits::front}, by_faces).areas[0] == 0);
  CHECK(on_floor({}, {"above", downwards, Emits::front}, by_faces).areas[0] == 1);
  CHECK(on_floor({}, {"below", rectangle(1, 3, -1, 1, -4), Emits::both}, by_faces).areas[0] == 0);
}

TEST_CASE("a panel that is not convex") {
  // The upper right quarter is missing: of sixteen squares twelve are left.
  const double e = 0x1p-10;
  const Corners angle{{1 - e, -1 - e, 4}, {3 + e, -1 - e, 4}, {3 + e, 0 + e, 4},
                      {2 + e, 0 + e, 4},  {2 + e, 1 + e, 4},  {1 - e, 1 + e, 4}};
  CHECK(on_floor({}, {"angle", angle, Emits::both}, by_faces).areas[0] == 0.75);
}

TEST_CASE("an obstacle with a vertex in the pyramid blocks the triangle") {
  // A needle goes from far above down to (1, 0.1, 2), mirrored in (0, 0.1 * 2 / 3), in one triangle.
  const Corners needle{{1.0625, 0.125, 2}, {40, 0.125, 3}, {40, 0.25, 3}};
  const MirrorOutcome outcome = on_floor({needle}, {"above", above, Emits::both}, by_faces);
  CHECK(marked(outcome.view) < 32);
  CHECK(outcome.view.reflections.statistics.blocked == 1);
}

TEST_CASE("the published test misses an obstacle without a vertex in the pyramid, and the exact one does not") {
  // A strip goes right across the panel's image, and beyond.
  const Corners strip = rectangle(0.625, 1.375, -6, 6, 2);
  const Panel panel{"above", above, Emits::both};
  CHECK(on_floor({strip}, panel, by_faces).areas[0] == 1);
  CHECK(on_floor({strip}, panel, by_faces).view.reflections.statistics.blocked == 0);
  CHECK(std::fabs(on_floor({strip}, panel, {}).areas[0] - 0.5) < 0.01);
}

TEST_CASE("obstacles behind the panel or behind the mirror block nothing") {
  for (const Corners& obstacle : {rectangle(1.5, 2.5, -0.5, 0.5, 5), rectangle(-0.5, 0.5, -0.5, 0.5, -1)}) {
    CAPTURE(obstacle[0].z());
    CHECK(on_floor({obstacle}, {"above", above, Emits::both}, by_faces).areas[0] == 1);
  }
}

TEST_CASE("given vertex normals bend what faces leave flat") {
  // There is one triangle; with its own normal it mirrors the panel, with normals to the side it does not.
  const Mesh mesh = mesh_of({{{-0.25, -0.25, 0}, {0.25, -0.25, 0}, {0, 0.25, 0}}});
  const std::vector<Vector3> aside(3, Vector3{-0.5, 0, 1});
  const std::vector<Panel> panels{{"above", above, Emits::both}};
  const auto area_with = [&](const ReflectionOptions& options, const std::vector<Vector3>& normals) {
    return reflected(mesh, panels, looking_down(mirror_eye), options, normals).areas[0];
  };
  CHECK(area_with(by_vertices, {}) == 0.125);
  CHECK(area_with(by_vertices, aside) == 0);
  CHECK(area_with(by_faces, aside) == 0.125);
}

TEST_CASE("parallel rays, and surfaces of any scale") {
  for (const double scale : {0x1p-400, 1.0, 0x1p400}) {
    CAPTURE(scale);
    std::vector<Corners> tiles = tiled_floor();
    Corners panel = rectangle(-0.5 - 0x1p-10, 0.5 + 0x1p-10, -0.5 - 0x1p-10, 0.5 + 0x1p-10, 3);
    for (Corners& tile : tiles) {
      for (Point3& p : tile) p = scale * p;
    }
    for (Point3& p : panel) p = scale * p;
    Camera camera = looking_down({0, 0, 4 * scale});
    camera.projection = Projection::orthographic;
    camera.right = {0.25 / scale, 0, 0};
    camera.up = {0, 0.25 / scale, 0};
    camera.eye = {{0, 0, 1}, 0};
    CHECK(marked(reflected(mesh_of(tiles), {{"panel", panel, Emits::both}}, camera, by_faces).view) == 32);
  }
}

TEST_CASE("with one convex panel and nothing in the way, what is marked is part of what reflects exactly") {
  constexpr std::uint64_t first_seed = 1;
  const std::uint64_t scenes = lattice::scene_count(200);
  std::uint64_t in_part = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const auto between = [&](double low, double high) {
      return std::round(256 * (low + (high - low) * std::ldexp(static_cast<double>(random() >> 11U), -53))) / 256;
    };
    // The dome is so shallow that no face is seen before another, nor above another's plane where light comes from.
    const double dome = between(0, 0.05);
    std::vector<Corners> surface;
    for (Corners tile : tiled_floor()) {
      if (tile.size() > 3) continue;
      for (Point3& p : tile) p.z() = -dome * (p.x() * p.x() + p.y() * p.y());
      surface.push_back(tile);
    }
    const Corners panel = rectangle(between(0, 2), between(2.5, 4), between(-2, 0), between(0.5, 2), 4);
    const Mesh mesh = mesh_of(surface);
    const std::vector<Panel> panels{{"panel", panel, Emits::both}};
    const MirrorOutcome exact = reflected(mesh, panels, looking_down(mirror_eye));
    const MirrorOutcome whole = reflected(mesh, panels, looking_down(mirror_eye), by_faces);
    CHECK(whole.areas[0] <= exact.areas[0] * (1 + 1e-9));
    in_part += whole.areas[0] > 0 && whole.areas[0] < 0.95 * exact.areas[0] ? 1 : 0;
  }
  // The generator made panels whose image ends within triangles.
  CHECK(2 * in_part >= scenes);
}

}  // namespace sightline::tests::reflecting_triangles_test
