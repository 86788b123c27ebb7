// Depth sort and the BSP tree: what is painted is what rays through the pixels' centres see; depth sort's split is
// needed; ties, touching and very high trees do no harm.
#include <doctest/doctest.h>

#include <cmath>

#include "peers/bsp_tree.h"
#include "peers/depth_sort.h"
#include "tests/oracle/crossing_scenes.h"
#include "tests/oracle/judge.h"
#include "tests/pixel_rays.h"
#include "tests/polygon_mesh.h"

using namespace sightline;
using namespace sightline::peers;
using sightline::testing::Corners;
using sightline::testing::seen_by_rays;
using sightline::testing::wrong_pixels;

namespace {

constexpr int resolution = 32;

struct Painters {
  int wrong_by_depth_sort = 0;
  int wrong_by_bsp_tree = 0;
  std::uint64_t moves = 0;
  std::uint64_t depth_sort_splits = 0;
  std::uint64_t unresolved = 0;
  std::uint64_t bsp_splits = 0;

  Painters& operator+=(const Painters& other) {
    wrong_by_depth_sort += other.wrong_by_depth_sort;
    wrong_by_bsp_tree += other.wrong_by_bsp_tree;
    moves += other.moves;
    depth_sort_splits += other.depth_sort_splits;
    unresolved += other.unresolved;
    bsp_splits += other.bsp_splits;
    return *this;
  }
};

// Rays need no facets cut along their common lines, and pieces' planes are not exactly their wholes'.
Painters run_painters(const Mesh& mesh, const Camera& camera, Sides sides,
                      Splitting splitting = Splitting::where_needed) {
  const ItemBuffer truth = seen_by_rays(mesh, project(mesh, camera, sides), resolution);
  const Mesh pieces = oracle::cut(mesh);
  const ProjectedScene scene = project(pieces, camera, sides);
  const FlatScene flat = flat_scene(pieces, scene);
  const DepthSorted sorted = sort_by_depth(flat, splitting);
  const BspTree tree = make_bsp(flat.polygons);
  return {wrong_pixels(scene, paint(sorted.polygons, resolution).buffer, truth),
          wrong_pixels(scene, paint(display_bsp(tree), resolution).buffer, truth),
          sorted.moves,
          sorted.splits,
          sorted.unresolved,
          tree.splits};
}

Camera from_above() {
  ViewPoint view;
  view.eye = {0, 0, 100};
  view.target = {0, 0, 0};
  return orthographic_camera("above", view, 32);
}

// From one end to the other, as wide across as said, its height changing along it.
Corners bar(const Point3& from, const Point3& to, double width) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double across_x = -(to.y - from.y) / length * width / 2;
  const double across_y = (to.x - from.x) / length * width / 2;
  return {{from.x - across_x, from.y - across_y, from.z},
          {to.x - across_x, to.y - across_y, to.z},
          {to.x + across_x, to.y + across_y, to.z},
          {from.x + across_x, from.y + across_y, from.z}};
}

// Along the sides of a regular polygon and beyond: each bar begins under the one before it and ends over the next one.
Mesh bars_in_a_ring(int count) {
  const double pi = std::acos(-1.0);
  const auto corner = [&](int i) {
    const double angle = 2 * pi * i / count + 0.1;
    return Point3{10 * std::cos(angle), 10 * std::sin(angle), 0};
  };
  std::vector<Corners> bars;
  for (int i = 0; i < count; ++i) {
    const Point3 from = corner(i);
    const Vector3 along = corner(i + 1) - from;
    const Vector3 rise{0, 0, 4};
    bars.push_back(bar(from - 0.3 * along, from + 1.3 * along + rise, 2));
  }
  return testing::mesh_of(bars);
}

}  // namespace

TEST_CASE("painters show what rays see: random scenes, ties of coplanar faces included") {
  Painters all;
  int ties = 0;
  for (std::uint64_t seed = 1; seed <= oracle::scene_count(400); ++seed) {
    const oracle::RandomScene scene = oracle::random_scene(seed);
    CAPTURE(seed);
    const Painters painters = run_painters(oracle::mesh_of(scene), scene.camera, scene.sides);
    CHECK(painters.wrong_by_depth_sort == 0);
    CHECK(painters.wrong_by_bsp_tree == 0);
    CHECK(painters.unresolved == 0);
    all += painters;
    ties += scene.notes.coplanar_overlap ? 1 : 0;
  }
  MESSAGE(ties << " scenes with ties, " << all.moves << " moves, " << all.depth_sort_splits << " and " << all.bsp_splits
               << " splits");
}

TEST_CASE("painters show what rays see: faces that pass through each other, cut along their common lines") {
  for (std::uint64_t seed = 1; seed <= oracle::scene_count(200); ++seed) {
    const oracle::RandomScene scene = oracle::crossing_scene(seed);
    CAPTURE(seed);
    const Painters painters = run_painters(oracle::mesh_of(scene), scene.camera, scene.sides);
    CHECK(painters.wrong_by_depth_sort == 0);
    CHECK(painters.wrong_by_bsp_tree == 0);
    CHECK(painters.unresolved == 0);
  }
}

TEST_CASE("bars that lie over each other in a ring: without its split depth sort is wrong, with it right") {
  for (const int count : {3, 4, 5, 8}) {
    CAPTURE(count);
    const Mesh bars = bars_in_a_ring(count);
    const Painters with = run_painters(bars, from_above(), Sides::both);
    CHECK(with.wrong_by_depth_sort == 0);
    CHECK(with.wrong_by_bsp_tree == 0);
    CHECK(with.depth_sort_splits > 0);
    CHECK(with.unresolved == 0);
    const Painters without = run_painters(bars, from_above(), Sides::both, Splitting::never);
    CHECK(without.wrong_by_depth_sort > 0);
    CHECK(without.unresolved > 0);
  }
}
