// The image without rounding, tier against tier: what filters, names and double words say of places and edges is what integers
// say, on scenes at the extremes of numbers, on few points, and moved off a lattice.
#include "sweep/segments/unrounded_image.h"

#include <doctest/doctest.h>

#include <functional>
#include <random>

#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_scenes.h"
#include "sweep/engine.h"
#include "tests/tools/unrounded_scenes.h"

namespace sightline::tests::unrounded_image_test {
namespace {

constexpr std::uint64_t first_seed = 1;

using Place = UnroundedImage::Place;

struct Tally {
  std::uint64_t places = 0;
  std::uint64_t sides = 0;
  std::uint64_t zeros = 0;
  std::uint64_t orders = 0;
  std::uint64_t equal = 0;
  UnroundedCounts counts;
};

// Every edge of a scene and every swap edge, and where they cross.
class TierCheck {
 public:
  TierCheck(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges)
      : scene_(scene), image_(scene, swap_edges) {
    for (std::size_t i = 0; i < scene.edge_count() + swap_edges.size(); ++i) {
      const EdgeId e(i);
      if (!image_.is_swap_edge(e) || image_.swap_edge(e).is_seen) edges_.push_back(e);
    }
    find_places();
  }

  void run(Tally& tally) const {
    for (const Place& p : places_) check_radius(p);
    check_turns(tally);
    check_sides(tally);
    check_orders(tally);
    tally.places += places_.size();
    tally.counts.exact_sides += image_.counts().exact_sides;
    tally.counts.exact_turns += image_.counts().exact_turns;
    tally.counts.exact_orders += image_.counts().exact_orders;
  }

 private:
  [[nodiscard]] bool is_within(EdgeId e, const ExactPlace& place) const {
    if (image_.is_swap_edge(e)) return true;
    const SceneEdge& edge = scene_.edges[e.index()];
    return sweep_compare(image_.exact(edge.top), place) <= 0 && sweep_compare(place, image_.exact(edge.bottom)) <= 0;
  }

  void find_places() {
    for (const EdgeId a : edges_) {
      for (const EdgeId b : edges_) {
        if (a.index() >= b.index() || turn(image_.exact_line(a), image_.exact_line(b)) == 0) continue;
        const ExactPlace place = image_.exact(Place{a, b});
        if (is_within(a, place) && is_within(b, place)) places_.push_back({a, b});
      }
    }
    if (places_.size() > most_places) places_.resize(most_places);
  }

  void check_radius(const Place& p) const {
    const ExactPlace exact = image_.exact(p);
    for (const CertifiedPlace& place : {image_.filtered_place(p), image_.certified(p)}) {
      if (!std::isfinite(place.radius)) continue;
      const auto off = [&](double approximate, const BigInteger& numerator) -> Rational {
        const Rational difference = Rational(approximate) - Rational(numerator, exact.w);
        return difference < 0 ? Rational(-difference) : difference;
      };
      CHECK(off(place.x, exact.x) <= Rational(place.radius));
      CHECK(off(place.y, exact.y) <= Rational(place.radius));
    }
  }

  void check_turns(Tally& tally) const {
    for (const EdgeId a : edges_) {
      for (const EdgeId b : edges_) {
        const Sign expected = a == b ? 0 : turn(image_.exact_line(a), image_.exact_line(b));
        CHECK(image_.turn(a, b) == expected);
        tally.zeros += expected == 0 ? 1 : 0;
      }
    }
  }

  void check_sides(Tally& tally) const {
    for (const EdgeId e : edges_) {
      const ExactLine line = image_.exact_line(e);
      for (std::size_t i = 0; i < scene_.unrounded.places.size(); ++i)
        CHECK(image_.side(e, PointId(i)) == side(line, image_.exact(PointId(i))));
      for (const Place& p : places_) {
        const Sign expected = side(line, image_.exact(p));
        CHECK(image_.side(e, p) == expected);
        ++tally.sides;
        tally.zeros += expected == 0 ? 1 : 0;
      }
    }
  }

  void check_orders(Tally& tally) const {
    for (const Place& p : places_) {
      for (const Place& q : places_) {
        const int expected = sweep_compare(image_.exact(p), image_.exact(q));
        CHECK(image_.compare(p, q) == expected);
        ++tally.orders;
        tally.equal += expected == 0 ? 1 : 0;
      }
      for (std::size_t i = 0; i < scene_.unrounded.places.size(); ++i)
        CHECK(image_.compare(p, PointId(i)) == sweep_compare(image_.exact(p), image_.exact(PointId(i))));
    }
  }

  static constexpr std::size_t most_places = 60;
  const ProjectedScene& scene_;
  UnroundedImage image_;
  std::vector<EdgeId> edges_;
  std::vector<Place> places_;
};

void check_scene(const Mesh& mesh, const Camera& camera, Tally& tally) {
  const ProjectedScene scene = project(uncrossed(mesh), camera, Sides::both, {Arithmetic::unrounded});
  const VisibleSegments segments = find_visible_segments(scene);
  TierCheck(scene, segments.swap_edges).run(tally);
}

void report(const Tally& tally) {
  MESSAGE(tally.places << " places; " << tally.sides << " sides, " << tally.orders << " orders, of which "
                       << tally.equal << " are equal; integers were asked for " << tally.counts.exact_sides
                       << " sides, " << tally.counts.exact_turns << " turns, " << tally.counts.exact_orders
                       << " orders");
}

}  // namespace

TEST_CASE("unrounded image: what is said at the extremes of numbers is what integers say") {
  Tally tally;
  const std::uint64_t scenes = lattice::scene_count(1000) / 10;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    check_scene(extreme_soup(random), camera_in_origin(), tally);
  }
  report(tally);
  CHECK(tally.places > 10 * scenes);
  CHECK(tally.counts.exact_sides + tally.counts.exact_orders > scenes);
}

TEST_CASE("unrounded image: what is said where much coincides, or nearly does, is what integers say") {
  Tally tally;
  const std::uint64_t scenes = lattice::scene_count(1000) / 10;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    check_scene(few_points_soup(random), on_grid_camera(random), tally);
    const lattice::RandomScene through = lattice::crossing_scene(seed);
    check_scene(moved(through, every_move[seed % every_move.size()]), through.camera, tally);
  }
  report(tally);
  CHECK(tally.equal > tally.places);
  CHECK(tally.zeros > tally.places);
}

}  // namespace sightline::tests::unrounded_image_test
