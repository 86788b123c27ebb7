// Z-buffer, Warnock and Watkins see what ray casting sees (ray_casting_test.cpp holds that against the exact visible
// polygons), and do it in their own ways: the counts say so.
#include <doctest/doctest.h>

#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_scenes.h"
#include "peers/pixels/ray_casting.h"
#include "peers/pixels/warnock.h"
#include "peers/pixels/watkins.h"
#include "peers/pixels/z_buffer.h"
#include "tests/peers/flat_polygons.h"
#include "tests/peers/pixel_rays.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::peer_pixels_test {
using namespace peers;

namespace {

ItemBuffer seen_by(const Peer& peer, const FlatScene& scene, int resolution) {
  return std::get<ItemBuffer>(peer.run(scene, resolution).seen);
}

std::uint64_t count_of(const Outcome& outcome, const std::string& what) {
  for (const Count& count : outcome.counts) {
    if (count.what == what) return count.number;
  }
  throw std::logic_error("no peer counts " + what);
}

struct Tally {
  std::uint64_t scenes = 0;
  std::size_t on_edges = 0;
  std::size_t differing = 0;  // in Watkins' buffer, because an edge passes within 1e-9 of the centre
};

// Z-buffer and Warnock decide at the centres by the same rule as ray casting: they are equal also where an edge passes
// through them.
void compare(const lattice::RandomScene& random, int resolution, Tally& tally) {
  const CutMesh mesh = lattice::cut(lattice::mesh_of(random));
  const ProjectedScene scene = project(mesh, random.camera, random.sides);
  const FlatScene flat = flat_scene(scene);
  const ItemBuffer by_rays = seen_by(ray_casting(), flat, resolution);
  for (const Peer& peer : {z_buffer(), warnock()}) {
    const int differing = differing_pixels(seen_by(peer, flat, resolution), by_rays);
    CHECK_MESSAGE(differing == 0, peer.name << " at " << resolution << "\n" << to_text(random));
  }
  const ItemBuffer by_watkins = seen_by(watkins(), flat, resolution);
  CHECK_MESSAGE(wrong_pixels(scene, by_watkins, by_rays) == 0, "watkins at " << resolution << "\n" << to_text(random));
  tally.on_edges += centres_on_edges(scene, resolution);
  tally.differing += static_cast<std::size_t>(differing_pixels(by_watkins, by_rays));
}

// Takes the first so many of the scenes of seeds 1, 2, ... without coplanar overlap.
void compare_scenes(lattice::RandomScene (*scene_of)(std::uint64_t), std::uint64_t count) {
  Tally tally;
  std::uint64_t seed = 0;
  while (tally.scenes < lattice::scene_count(count)) {
    const lattice::RandomScene random = scene_of(++seed);
    if (random.notes.coplanar_overlap) continue;
    ++tally.scenes;
    for (const int resolution : {16, 64, 100}) compare(random, resolution, tally);
  }
  MESSAGE("seeds 1 to " << seed << ": " << tally.scenes << " scenes without coplanar overlap; " << tally.on_edges
                        << " centres exactly on edges; " << tally.differing
                        << " pixels of Watkins' differ, an edge within 1e-9 of their centres");
  CHECK(tally.on_edges > 10 * tally.scenes);
}

// Two tilted squares pass through each other along x = 0.1, before a floor; a contract of FlatScene is broken.
FlatScene crossing_squares() {
  const std::vector<Point2> square = rectangle({-0.71, -0.63}, {0.77, 0.69});
  return flat_scene_of({{{1, 0.5, -0.1}, square}, {{-1, 0.5, 0.1}, square}, {{0, 0, 5}, rectangle({-1, -1}, {1, 1})}});
}

}  // namespace

TEST_CASE("peers at image precision: what ray casting sees, random scenes") {
  compare_scenes(lattice::random_scene, 200);
}

TEST_CASE("peers at image precision: what ray casting sees, faces that passed through each other") {
  compare_scenes(lattice::crossing_scene, 100);
}

TEST_CASE("peers at image precision: polygons that pass through each other need no cut") {
  const FlatScene scene = crossing_squares();
  const ItemBuffer by_rays = seen_by(ray_casting(), scene, 64);
  CHECK(by_rays.at(20, 32) == FaceId(0));
  CHECK(by_rays.at(40, 32) == FaceId(1));
  for (const Peer& peer : {z_buffer(), warnock(), watkins()}) {
    CHECK_MESSAGE(differing_pixels(seen_by(peer, scene, 64), by_rays) == 0, peer.name);
  }
}

TEST_CASE("peers at image precision: where depths are equal the lower face index is in front") {
  const DepthPlane plane{0.25, 0.5, 1};
  const FlatScene scene =
      flat_scene_of({{plane, rectangle({-0.8, -0.8}, {0.4, 0.8})}, {plane, rectangle({-0.4, -0.6}, {0.8, 0.6})}});
  const ItemBuffer by_rays = seen_by(ray_casting(), scene, 16);
  CHECK(by_rays.at(7, 7) == FaceId(0));
  CHECK(by_rays.at(13, 7) == FaceId(1));
  for (const Peer& peer : {z_buffer(), warnock(), watkins()}) {
    CHECK_MESSAGE(differing_pixels(seen_by(peer, scene, 16), by_rays) == 0, peer.name);
  }
}

TEST_CASE("peers at image precision: an empty scene") {
  for (const Peer& peer : {ray_casting(), z_buffer(), warnock(), watkins()}) {
    CHECK_MESSAGE(differing_pixels(seen_by(peer, {}, 7), ItemBuffer(7)) == 0, peer.name);
  }
}

TEST_CASE("z-buffer: hidden polygons are touched, and painted if they come first") {
  const std::vector<Point2> window = rectangle({-1, -1}, {1, 1});
  const Outcome far_first = z_buffer().run(flat_scene_of({{{0, 0, 2}, window}, {{0, 0, 1}, window}}), 8);
  const Outcome near_first = z_buffer().run(flat_scene_of({{{0, 0, 1}, window}, {{0, 0, 2}, window}}), 8);
  CHECK(count_of(far_first, "pixels touched") == 128);
  CHECK(count_of(near_first, "pixels touched") == 128);
  CHECK(count_of(far_first, "pixels painted") == 128);
  CHECK(count_of(near_first, "pixels painted") == 64);
}

TEST_CASE("ray casting: a ray is tested only within a polygon's extent") {
  const Outcome outcome = ray_casting().run(flat_scene_of({{{0, 0, 1}, {{-1, -1}, {0, -1}, {0, 0}}}}), 8);
  CHECK(count_of(outcome, "rays") == 64);
  CHECK(count_of(outcome, "rays tested against polygons") == 16);
}

TEST_CASE("Warnock: an enclosing polygon in front of all others ends the subdivision") {
  const std::vector<Point2> window = rectangle({-1, -1}, {1, 1});
  const std::vector<Point2> small = rectangle({-0.3, -0.3}, {0.2, 0.2});
  const Outcome one = warnock().run(flat_scene_of({{{0, 0, 1}, window}}), 64);
  CHECK(count_of(one, "rectangles") == 1);
  const Outcome hidden =
      warnock().run(flat_scene_of({{{0, 0, 2}, window}, {{0, 0, 3}, small}, {{0, 0, 1}, window}}), 64);
  CHECK(count_of(hidden, "rectangles") == 1);
  const Outcome in_front = warnock().run(flat_scene_of({{{0, 0, 2}, window}, {{0, 0, 1}, small}}), 64);
  CHECK(count_of(in_front, "pixels decided alone") > 0);
  CHECK(count_of(in_front, "rectangles") < 64 * 64 / 4);
}

TEST_CASE("Warnock: a hidden polygon whose plane comes in front at a corner is not known to be hidden") {
  // In the slides' case 3 it is behind the enclosing polygon all over its own extent, in front of it at the window's
  // corners.
  const FlatScene scene =
      flat_scene_of({{{0, 0, 1}, rectangle({-1, -1}, {1, 1})}, {{2, 0, 2}, rectangle({-0.3, -0.3}, {0.2, 0.2})}});
  const Outcome outcome = warnock().run(scene, 64);
  CHECK(count_of(outcome, "rectangles") == 1 + 4 + 2 * 4);
  CHECK(count_of(outcome, "pixels decided alone") == 0);
}

TEST_CASE("Watkins: the active edges of the slides' two triangles") {
  // A, B, C and D, E, F are as in the slides' figure; from scan line to scan line AET holds AB AC; AB AC FD FE; AB DE
  // CB FE.
  const FlatScene scene = flat_scene_of(
      {{{0, 0, 1}, {{-0.7, -0.95}, {0.2, -0.1}, {-0.5, 0.95}}}, {{0, 0, 2}, {{0.6, -0.6}, {0.8, 0.95}, {0, 0}}}});
  const Outcome outcome = watkins().run(scene, 8);
  CHECK(count_of(outcome, "active edges") == 2 * 2 + 6 * 4);
}

TEST_CASE("Watkins: depths are computed only where segments overlap") {
  const std::vector<Point2> left = rectangle({-1, -1}, {0.5, 1});
  const Outcome apart = watkins().run(flat_scene_of({{{0, 0, 1}, left}, {{0, 0, 2}, rectangle({0.5, -1}, {1, 1})}}), 8);
  CHECK(count_of(apart, "sample spans") == 2 * 8);
  CHECK(count_of(apart, "depths computed") == 0);
  const Outcome over = watkins().run(flat_scene_of({{{0, 0, 1}, left}, {{0, 0, 2}, rectangle({0, -1}, {1, 0})}}), 8);
  CHECK(count_of(over, "sample spans") == 4 * 3 + 4 * 1);
  CHECK(count_of(over, "depths computed") == 4 * (2 * 2));
}

}  // namespace sightline::tests::peer_pixels_test
