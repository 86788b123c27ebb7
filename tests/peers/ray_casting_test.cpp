// Ray casting sees what the exact visible polygons say at the pixels' centres: it is what the other peers at image
// precision are held to (peer_pixels_test.cpp).
#include <doctest/doctest.h>

#include "oracle/judging/judge.h"
#include "oracle/judging/ray_caster.h"
#include "oracle/scenes/crossing_scenes.h"
#include "peers/pixels/ray_casting.h"
#include "tests/peers/flat_polygons.h"
#include "tests/peers/pixel_rays.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::ray_casting_test {
using namespace peers;

namespace {

ItemBuffer seen_in_polygons(const View& view, int resolution) {
  ItemBuffer buffer(resolution);
  const std::vector<ImagePoint> rays = rays_through_centres(buffer, view.scene.grid_bits);
  const auto around = lattice::polygons_around(view, rays);
  std::size_t ray = 0;
  for (int row = resolution - 1; row >= 0; --row) {
    for (int column = 0; column < resolution; ++column, ++ray) {
      REQUIRE(around[ray].size() <= 1);
      if (!around[ray].empty()) buffer.paint(column, row, view.polygons.polygons[around[ray].front()].face);
    }
  }
  return buffer;
}

struct SeenTwice {
  ItemBuffer by_rays;
  ItemBuffer exact;
  ProjectedScene scene;
};

SeenTwice look_at(const lattice::RandomScene& random, int resolution) {
  const CutMesh mesh = lattice::cut(lattice::mesh_of(random));
  const View view = analyzed(mesh, random.camera, random.sides);
  const Outcome outcome = ray_casting().run(flat_scene(view.scene), resolution);
  return {std::get<ItemBuffer>(outcome.seen), seen_in_polygons(view, resolution), view.scene};
}

// Takes the first so many of the scenes of seeds 1, 2, ... without coplanar overlap.
void check_scenes(lattice::RandomScene (*scene_of)(std::uint64_t), std::uint64_t count) {
  std::uint64_t seed = 0;
  std::size_t on_edges = 0;
  for (std::uint64_t checked = 0; checked < lattice::scene_count(count); ++seed) {
    const lattice::RandomScene random = scene_of(seed + 1);
    if (random.notes.coplanar_overlap) continue;
    ++checked;
    for (const int resolution : {16, 64, 100}) {
      const SeenTwice seen = look_at(random, resolution);
      CHECK_MESSAGE(wrong_pixels(seen.scene, seen.by_rays, seen.exact) == 0, "resolution " << resolution << "\n"
                                                                                           << to_text(random));
      on_edges += centres_on_edges(seen.scene, resolution);
    }
  }
  MESSAGE("seeds 1 to " << seed << ": " << lattice::scene_count(count) << " scenes without coplanar overlap; "
                        << on_edges << " centres exactly on edges");
  CHECK(on_edges > 10 * lattice::scene_count(count));
}

}  // namespace

TEST_CASE("ray casting: the exact visible polygons at the pixels' centres, random scenes") {
  check_scenes(lattice::random_scene, 200);
}

TEST_CASE("ray casting: the exact visible polygons at the pixels' centres, faces that pass through each other") {
  check_scenes(lattice::crossing_scene, 100);
}

TEST_CASE("ray casting: double arithmetic does not find the depths of coplanar faces equal") {
  const lattice::RandomScene random = lattice::crossing_scene(138);
  REQUIRE(random.notes.coplanar_overlap);
  const SeenTwice seen = look_at(random, 64);
  CHECK(wrong_pixels(seen.scene, seen.by_rays, seen.exact) > 0);
}

TEST_CASE("ray casting: what no ray meets is not seen") {
  // The triangle is between the centres of the pixels, which are at -1/2 and 1/2.
  const FlatScene flat = tests::flat_scene_of({{{0, 0, 1}, {{-0.4, -0.4}, {0.4, -0.4}, {0, 0.4}}}});
  const auto seen = std::get<ItemBuffer>(ray_casting().run(flat, 2).seen);
  for (const int row : {0, 1}) CHECK((!seen.at(0, row).valid() && !seen.at(1, row).valid()));
}

}  // namespace sightline::tests::ray_casting_test
