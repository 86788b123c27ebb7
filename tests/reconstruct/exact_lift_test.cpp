// Lifts by numbers with bounds against those in integers: every bit, on random scenes that pass through themselves.
#include "reconstruct/labelling/exact_lift.h"

#include <doctest/doctest.h>

#include "geometry/mesh/facet_plane.h"
#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_scenes.h"
#include "sweep/engine.h"
#include "tests/tools/unrounded_scenes.h"

namespace sightline::tests::exact_lift_test {
namespace {

struct Tally {
  std::size_t certain = 0;
  std::size_t open = 0;

  void check(const std::optional<Point3>& lifted, const Point3& exact) {
    ++(lifted ? certain : open);
    if (lifted) CHECK(*lifted == exact);
  }
};

void check_planes(const ImagePoints& points, Tally& tally) {
  const CertainLift certain(points);
  PlaneLift lift(points);
  for (const VisibleSegment& s : points.segments().segments) {
    const FacetId surface = surface_of(points.scene().mesh(), s.facet);
    lift.begin(surface);
    for (const PointId p : {s.start, s.end}) tally.check(certain.to_plane(surface, p), lift.exact(p));
  }
}

void check_edges(const ImagePoints& points, Tally& tally) {
  const CertainLift certain(points);
  EdgeLift lift(points);
  for (const EdgeSplit& split : points.segments().splits) {
    if (!split.mesh_edge.valid()) continue;
    tally.check(certain.to_edge(split.mesh_edge, split.point), lift.exact(split.mesh_edge, split.point));
  }
}

}  // namespace

TEST_CASE("lifts with bounds have the bits of those in integers") {
  Tally planes;
  Tally edges;
  const std::uint64_t scenes = lattice::scene_count(1000) / 5;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    CAPTURE(seed);
    const lattice::RandomScene random = lattice::crossing_scene(seed);
    for (const Moved how : every_move) {
      CAPTURE(static_cast<int>(how));
      const Mesh mesh = moved(random, how);
      // What cutting made is no double.
      const CutMesh cut_or_not = seed % 4 == 0 ? lattice::cut(mesh) : uncrossed(mesh);
      const ProjectedScene scene = project(cut_or_not, random.camera, random.sides, {Arithmetic::unrounded});
      const VisibleSegments segments = find_visible_segments(scene);
      const ImagePoints points(scene, segments);
      check_planes(points, planes);
      check_edges(points, edges);
    }
  }
  CHECK(planes.certain > 100 * scenes);
  CHECK(planes.open > scenes);
  CHECK(edges.certain > 10 * scenes);
  CHECK(edges.open > scenes);
}

TEST_CASE("lifts with bounds have the bits of those in integers at the extremes of numbers") {
  Tally planes;
  Tally edges;
  const std::uint64_t scenes = lattice::scene_count(1000) / 10;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const Mesh mesh = extreme_soup(random);
    const ProjectedScene scene = project(uncrossed(mesh), camera_in_origin(), Sides::both, {Arithmetic::unrounded});
    const VisibleSegments segments = find_visible_segments(scene);
    const ImagePoints points(scene, segments);
    check_planes(points, planes);
    check_edges(points, edges);
  }
  MESSAGE(planes.certain << " and " << edges.certain << " with bounds, " << planes.open << " and " << edges.open
                         << " left open");
  CHECK(planes.certain > 10 * scenes);
  CHECK(planes.open > scenes / 10);
  CHECK(edges.certain > scenes);
  CHECK(edges.open > scenes / 100);
}

}  // namespace sightline::tests::exact_lift_test
