// Depth sort and the BSP tree: what is painted is what rays through the pixels' centres see; depth sort's split is
// needed; ties, touching and very high trees do no harm.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_scenes.h"
#include "peers/painters/bsp_tree.h"
#include "peers/painters/depth_sort.h"
#include "peers/scene/polygon_split.h"
#include "tests/peers/pixel_rays.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"
#include "tests/tools/random_surfaces.h"

namespace sightline::tests::peer_painters_test {
using namespace peers;

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

// Rays need no facets cut along their common lines, and pieces' planes are not exactly their uncut facets'.
Painters run_painters(const Mesh& mesh, const Camera& camera, Sides sides,
                      Splitting splitting = Splitting::where_needed) {
  const ItemBuffer truth = seen_by_rays(project(mesh, camera, sides), resolution);
  const CutMesh pieces = lattice::cut(mesh);
  const ProjectedScene scene = project(pieces, camera, sides);
  const FlatScene flat = flat_scene(scene);
  const DepthSorted sorted = sort_by_depth(flat, splitting);
  const BspTree tree = make_bsp(flat.polygons);
  return {wrong_pixels(scene, paint(sorted.polygons, resolution).buffer, truth),
          wrong_pixels(scene, paint(display_bsp(tree), resolution).buffer, truth),
          sorted.moves,
          sorted.splits,
          sorted.unresolved,
          tree.splits};
}

// The triangles have any size, place and direction, and most pass through others.
Mesh random_triangles(std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto coordinate = [&engine] { return std::ldexp(static_cast<double>(engine() >> 11), -48) - 16; };
  std::vector<Corners> triangles(24);
  for (Corners& triangle : triangles) {
    for (int i = 0; i < 3; ++i) {
      const double x = coordinate();
      const double y = coordinate();
      triangle.push_back({x, y, coordinate()});
    }
  }
  return tests::mesh_of(triangles);
}

Camera from_above() {
  ViewPoint view;
  view.eye = {0, 0, 100};
  view.target = {0, 0, 0};
  return orthographic_camera("above", view, 32);
}

// Rounds to a multiple of 1/64, so that what is added up of such numbers is exact.
double rounded(double x) { return std::round(64 * x) / 64; }

// The bar goes from one end to the other and is two wide, its height changing along it only: it is a parallelogram,
// exactly planar.
Corners bar(const Point3& from, const Point3& to) {
  const double length = std::hypot(to.x() - from.x(), to.y() - from.y());
  const Vector3 across{rounded((from.y() - to.y()) / length), rounded((to.x() - from.x()) / length), 0};
  const Point3 begin{rounded(from.x()), rounded(from.y()), from.z()};
  const Point3 end{rounded(to.x()), rounded(to.y()), to.z()};
  return {begin - across, end - across, end + across, begin + across};
}

// The bars lie along the sides of a regular polygon and beyond: each begins under the one before it and ends over the
// next one.
Mesh bars_in_a_ring(int count) {
  const double pi = std::acos(-1.0);
  const auto corner = [&](int i) -> Vector3 {
    const double angle = 2 * pi * i / count + 0.1;
    return Point3{10 * std::cos(angle), 10 * std::sin(angle), 0};
  };
  std::vector<Corners> bars;
  for (int i = 0; i < count; ++i) {
    const Point3 from = corner(i);
    const Vector3 along = corner(i + 1) - from;
    const Vector3 rise{0, 0, 4};
    bars.push_back(bar(from - 0.3 * along, from + 1.3 * along + rise));
  }
  return tests::mesh_of(bars);
}

}  // namespace

TEST_CASE("painters show what rays see: random scenes, ties of coplanar faces included") {
  Painters all;
  int ties = 0;
  for (std::uint64_t seed = 1; seed <= lattice::scene_count(400); ++seed) {
    const lattice::RandomScene scene = lattice::random_scene(seed);
    CAPTURE(seed);
    const Painters painters = run_painters(lattice::mesh_of(scene), scene.camera, scene.sides);
    CHECK(painters.wrong_by_depth_sort == 0);
    CHECK(painters.wrong_by_bsp_tree == 0);
    CHECK(painters.unresolved == 0);
    all += painters;
    ties += scene.notes.coplanar_overlap ? 1 : 0;
  }
  CHECK(ties > 0);
  CHECK(all.moves > 0);
  CHECK(all.depth_sort_splits > 0);
  CHECK(all.bsp_splits > 0);
}

TEST_CASE("painters show what rays see: faces that pass through each other, cut along their common lines") {
  for (std::uint64_t seed = 1; seed <= lattice::scene_count(200); ++seed) {
    const lattice::RandomScene scene = lattice::crossing_scene(seed);
    CAPTURE(seed);
    const Painters painters = run_painters(lattice::mesh_of(scene), scene.camera, scene.sides);
    CHECK(painters.wrong_by_depth_sort == 0);
    CHECK(painters.wrong_by_bsp_tree == 0);
    CHECK(painters.unresolved == 0);
  }
}

TEST_CASE("painters show what rays see: many triangles off any grid") {
  Painters all;
  for (std::uint64_t seed = 1; seed <= lattice::scene_count(10); ++seed) {
    CAPTURE(seed);
    const Painters painters = run_painters(random_triangles(seed), from_above(), Sides::both);
    CHECK(painters.wrong_by_depth_sort == 0);
    CHECK(painters.wrong_by_bsp_tree == 0);
    CHECK(painters.unresolved == 0);
    all += painters;
  }
  CHECK(all.moves > 0);
  CHECK(all.depth_sort_splits > 0);
  CHECK(all.bsp_splits > 0);
}

TEST_CASE("painters show what rays see: surfaces of some hundred facets") {
  for (std::uint64_t seed = 1; seed <= lattice::scene_count(12); ++seed) {
    CAPTURE(seed);
    const tests::RandomSurfaces surfaces = tests::random_surfaces(seed);
    const Painters painters = run_painters(surfaces.mesh, surfaces.camera, Sides::both);
    CHECK(painters.wrong_by_depth_sort == 0);
    CHECK(painters.wrong_by_bsp_tree == 0);
    CHECK(painters.unresolved == 0);
  }
}

TEST_CASE("bars that lie over each other in a ring: without its split depth sort is wrong, with it right") {
  for (const int count : {3, 4, 8}) {
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

TEST_CASE("in a ring of eight no bar is across its neighbours' planes: the split has to look farther along the ring") {
  const Mesh bars = bars_in_a_ring(8);
  const ProjectedScene scene = project(bars, from_above(), Sides::both);
  const std::vector<FlatPolygon> polygons = flat_scene(scene).polygons;
  REQUIRE(polygons.size() == 8);
  for (std::size_t i = 0; i < 8; ++i) {
    const FlatPolygon& next = polygons[(i + 1) % 8];
    CHECK(side_of(polygons[i], next.plane) == Side::nearer);
    CHECK(side_of(next, polygons[i].plane) == Side::farther);
  }
}

TEST_CASE("as peers they give an item buffer and say how much work it was") {
  const Mesh bars = bars_in_a_ring(8);
  const ProjectedScene scene = project(bars, from_above(), Sides::both);
  const ItemBuffer truth = seen_by_rays(scene, resolution);
  for (const Peer& peer : {depth_sort(), bsp_tree()}) {
    CAPTURE(peer.name);
    const Outcome outcome = peer.run(flat_scene(scene), resolution);
    CHECK(wrong_pixels(scene, std::get<ItemBuffer>(outcome.seen), truth) == 0);
    for (const Count& count : outcome.counts) {
      CAPTURE(count.what);
      CHECK((count.number > 0) == (count.what != "cycles that no plane cuts"));
    }
  }
}

}  // namespace sightline::tests::peer_painters_test
