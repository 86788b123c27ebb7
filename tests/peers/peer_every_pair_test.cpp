// The generic object-precision algorithm sees what the sweep sees.
#include <doctest/doctest.h>

#include <cmath>

#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_scenes.h"
#include "oracle/scenes/random_scenes.h"
#include "peers/painters/every_pair.h"
#include "tests/peers/peer_parts.h"
#include "tests/tools/polygon_mesh.h"
#include "tests/tools/random_surfaces.h"

namespace sightline::tests::peer_every_pair_test {
namespace {

using lattice::RandomScene;
using peers::every_pair;

constexpr double tolerance = 1e-9;

void check_equals_sweep(const PartsCase& parts) {
  CHECK(largest_error(parts) <= tolerance);
  CHECK(overlap_within_faces(parts.parts) <= tolerance);
}

// Returns how many pairs of projections overlapped.
std::uint64_t check_random_scene(const RandomScene& scene) {
  INFO("seed ", scene.seed);
  const PartsCase parts = parts_case(every_pair(), lattice::cut(mesh_of(scene)), scene.camera, scene.sides);
  check_equals_sweep(parts);
  return number_of(parts, "pairs whose projections overlap");
}

const Corners table{{-0.75, -0.75, 0}, {0.75, -0.75, 0}, {0.75, 0.75, 0}, {-0.75, 0.75, 0}};

Corners raised(Corners corners, double height) {
  for (Point3& p : corners) p.z() += height;
  return corners;
}

}  // namespace

TEST_CASE("every pair: random scenes, coplanar overlap included") {
  std::uint64_t overlaps = 0;
  std::uint64_t coplanar = 0;
  std::uint64_t pinholes = 0;
  for (std::uint64_t seed = 1; seed <= lattice::scene_count(600); ++seed) {
    const RandomScene scene = lattice::random_scene(seed);
    overlaps += check_random_scene(scene);
    coplanar += scene.notes.coplanar_overlap ? 1 : 0;
    pinholes += scene.camera.projection == Projection::perspective ? 1 : 0;
  }
  MESSAGE(overlaps << " pairs overlap; " << coplanar << " scenes with coplanar overlap; " << pinholes << " pinholes");
  CHECK(overlaps > 3 * lattice::scene_count(600));
  CHECK(coplanar > lattice::scene_count(600) / 20);
  CHECK(pinholes > lattice::scene_count(600) / 5);
}

TEST_CASE("every pair: random scenes whose faces pass through each other, cut along their common lines") {
  std::uint64_t overlaps = 0;
  for (std::uint64_t seed = 1; seed <= lattice::scene_count(200); ++seed) {
    overlaps += check_random_scene(lattice::crossing_scene(seed));
  }
  CHECK(overlaps > 3 * lattice::scene_count(200));
}

TEST_CASE("every pair: a small square before a table leaves a frame of convex parts") {
  const Corners square{{-0.25, -0.25, 1}, {0.25, -0.25, 1}, {0.25, 0.25, 1}, {-0.25, 0.25, 1}};
  const PartsCase parts = parts_case(every_pair(), mesh_of({table, square}), straight_down());
  check_equals_sweep(parts);
  CHECK(parts.seen[0] == doctest::Approx(2.25 - 0.25));
  CHECK(parts.seen[1] == doctest::Approx(0.25));
  CHECK(parts.parts.size() == 5);
}

TEST_CASE("every pair: what is behind is not seen at all") {
  const PartsCase parts = parts_case(every_pair(), mesh_of({raised(table, -1), table}), straight_down());
  CHECK(parts.seen[0] == 0);
  CHECK(parts.seen[1] == 2.25);
  CHECK(parts.parts.size() == 1);
}

TEST_CASE("every pair: a part that what is in front does not meet stays whole") {
  const Corners over{{0, -0.6, 2}, {0.6, -0.6, 2}, {0.6, 0, 2}};
  const Corners between{{0.4, -0.55, 1}, {0.55, -0.55, 1}, {0.55, -0.4, 1}, {0.4, -0.4, 1}};
  const PartsCase parts = parts_case(every_pair(), mesh_of({table, over, between}), straight_down());
  check_equals_sweep(parts);
  CHECK(parts.parts.size() == 3 + 1);
}

TEST_CASE("every pair: of coplanar faces the lower one is in front") {
  const Corners upper{{0, 0, 0}, {0.5, -0.125, 0}, {0.75, 1, 0}, {-0.5, 0.875, 0}};
  const PartsCase first = parts_case(every_pair(), mesh_of({table, upper}), straight_down());
  CHECK(first.seen[0] == 2.25);
  check_equals_sweep(first);
  const PartsCase second = parts_case(every_pair(), mesh_of({upper, table}), straight_down());
  CHECK(second.seen[1] < 2);
  check_equals_sweep(second);
}

TEST_CASE("every pair: three bars, each over one and under another") {
  const auto bar = [](double angle) {
    const auto turned = [&](double x, double y, double z) {
      return Point3{x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle), z};
    };
    return Corners{turned(-0.8, -0.4, -0.5), turned(0.8, -0.4, 0.5), turned(0.8, -0.2, 0.5), turned(-0.8, -0.2, -0.5)};
  };
  const double third = 2.0943951023931953;
  const PartsCase parts = parts_case(every_pair(), mesh_of({bar(0), bar(third), bar(2 * third)}), straight_down());
  check_equals_sweep(parts);
  for (const double area : parts.seen) CHECK(area < 0.32 - 0.02);
}

TEST_CASE("every pair: neighbours share their edges' lines and leave no slivers") {
  std::vector<Corners> polygons{raised(table, -1)};
  for (int i = 0; i < 32; ++i) {
    const double from = -0.75 + 0.046875 * i;
    const double to = from + 0.046875;
    polygons.push_back(
        {{from, from / 3 - 0.25, 0}, {to, to / 3 - 0.25, 0}, {to, to / 3 + 0.1, 0}, {from, from / 3 + 0.1, 0}});
  }
  const PartsCase parts = parts_case(every_pair(), mesh_of(polygons), straight_down());
  check_equals_sweep(parts);
  CHECK(number_of(parts, "unobstructed parts") <= 32 + 2 * 32 + 2);
}

TEST_CASE("every pair: rounding to the grid dents a polygon at a short edge") {
  const double cell = 0x1p-40;
  const double slope = 0.98 / 3;
  const Corners dented{{-0.5, -0.5, 1},
                       {0.5, -0.5, 1},
                       {0.5, 0.249 + 0.5 * slope, 1},
                       {3 * cell, 0.25 + 1.49 * cell, 1},  // rounded down
                       {0, 0.25 + 0.51 * cell, 1},         // rounded up: the edge between them becomes level
                       {-0.5, 0.249 - 0.5 * slope, 1}};
  const Mesh mesh = mesh_of({table, dented});
  REQUIRE(mesh.facet_count() == 2);
  check_equals_sweep(parts_case(every_pair(), mesh, straight_down()));
}

TEST_CASE("every pair: random surfaces, cut along their common lines") {
  std::uint64_t parts_seen = 0;
  std::uint64_t overlaps = 0;
  for (std::uint64_t seed = 1; seed <= lattice::scene_count(60); ++seed) {
    INFO("seed ", seed);
    const RandomSurfaces surfaces = random_surfaces(seed);
    const PartsCase parts = parts_case(every_pair(), lattice::cut(surfaces.mesh), surfaces.camera);
    check_equals_sweep(parts);
    parts_seen += number_of(parts, "unobstructed parts");
    overlaps += number_of(parts, "pairs whose projections overlap");
  }
  MESSAGE(overlaps << " pairs overlap, " << parts_seen << " parts are seen");
  CHECK(overlaps > 100 * lattice::scene_count(60));
  CHECK(parts_seen > 100 * lattice::scene_count(60));
}

}  // namespace sightline::tests::peer_every_pair_test
