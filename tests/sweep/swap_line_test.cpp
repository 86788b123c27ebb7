// Swap edges by a filter against those in integers, on planes at the extremes: far away, nearly one plane, nearly parallel to the
// image, nearly edge-on.
#include "sweep/segments/swap_line.h"

#include <doctest/doctest.h>

#include <random>

#include "tests/tools/polygon_mesh.h"
#include "tests/tools/unrounded_scenes.h"

namespace sightline::tests::swap_line_test {
namespace {

constexpr unsigned seed = 20261130;

Point3 random_point(std::mt19937& random, double spread) {
  std::uniform_real_distribution<double> coordinate(-spread, spread);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

// Two triangles around one point; the second is the first one, moved by a little of its size, or any. No corner stays where it
// was: of two faces at one place one would be left out.
Mesh two_planes(std::mt19937& random) {
  const double size = std::ldexp(1.0, -static_cast<int>(random() % 12));
  const Point3 middle = random_point(random, 0.5);
  Corners first;
  for (int i = 0; i < 3; ++i) first.push_back(middle + random_point(random, size));
  const bool nearly_one = random() % 2 == 0;
  const double moved = std::ldexp(size, -static_cast<int>(random() % 36));
  Corners second;
  for (const Point3& p : first)
    second.push_back(nearly_one ? Point3(p + random_point(random, moved))
                                : Point3(middle + random_point(random, size)));
  return mesh_of({first, second});
}

ProjectedScene projected(std::mt19937& random) {
  Mesh mesh = two_planes(random);
  const ViewPoint view{random_point(random, 1) + Vector3{0, 0, 3}, random_point(random, 0.1), {0, 1, 0}, 1, {}, {}};
  const Camera camera = random() % 2 == 0 ? perspective_camera("c", view, 60) : orthographic_camera("c", view, 3);
  return project(uncrossed(std::move(mesh)), camera, Sides::both, {Arithmetic::unrounded});
}

double share(const BigInteger& coefficient, const BigInteger& largest) {
  return rounded_quotient(coefficient, largest);
}

void check_same(const SwapEdge& filtered, const SwapEdge& exact) {
  CHECK(filtered.is_seen);
  CHECK(exact.is_seen);
  CHECK(filtered.first_nearer == exact.first_nearer);
  // Both are scaled to a largest coefficient of about 1.
  const double reach = 4 * (filtered.radius + exact.radius);
  CHECK(std::fabs(filtered.a - exact.a) <= reach);
  CHECK(std::fabs(filtered.b - exact.b) <= reach);
  CHECK(std::fabs(filtered.c - exact.c) <= reach);
}

}  // namespace

TEST_CASE("swap edges: the filter and the integers agree") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  int filtered = 0;
  int open = 0;
  for (int i = 0; i < 3000; ++i) {
    CAPTURE(i);
    const ProjectedScene scene = projected(random);
    REQUIRE(scene.mesh().facet_count() == 2);
    ExactNearness nearness(scene);
    const auto of_first = bounded_nearness(scene, FacetId(0));
    const auto of_second = bounded_nearness(scene, FacetId(1));
    const SwapEdge exact = swap_edge_tiers::exact(nearness.of(FacetId(0)), nearness.of(FacetId(1)));
    const auto edge = of_first && of_second ? swap_edge_tiers::filtered(*of_first, *of_second) : std::nullopt;
    ++(edge ? filtered : open);
    if (edge) check_same(*edge, exact);
  }
  CHECK(filtered > 1000);
  CHECK(open > 100);
}

TEST_CASE("swap edges: the filter and the integers agree at the extremes of numbers") {
  std::size_t filtered = 0;
  std::size_t open = 0;
  for (std::uint64_t extreme_seed = 1; extreme_seed <= 3000; ++extreme_seed) {
    CAPTURE(extreme_seed);
    std::mt19937_64 random(extreme_seed);
    const ProjectedScene scene =
        project(uncrossed(extreme_soup(random)), camera_in_origin(), Sides::both, {Arithmetic::unrounded});
    ExactNearness nearness(scene);
    for (std::size_t i = 0; i < scene.mesh().facet_count(); ++i) {
      for (std::size_t j = i + 1; j < scene.mesh().facet_count(); ++j) {
        const auto [first, second] = std::array{FacetId(i), FacetId(j)};
        if (scene.status[i] != FacetStatus::in_view || scene.status[j] != FacetStatus::in_view) continue;
        const auto of_first = bounded_nearness(scene, first);
        const auto of_second = bounded_nearness(scene, second);
        const auto edge = of_first && of_second ? swap_edge_tiers::filtered(*of_first, *of_second) : std::nullopt;
        ++(edge ? filtered : open);
        if (edge) check_same(*edge, swap_edge_tiers::exact(nearness.of(first), nearness.of(second)));
      }
    }
  }
  MESSAGE(filtered << " by the filter, " << open << " left open");
  CHECK(filtered > 1000);
  CHECK(open > 100);
}

TEST_CASE("swap edges: the line in integers is the one whose shares the edge has") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    const ProjectedScene scene = projected(random);
    REQUIRE(scene.mesh().facet_count() == 2);
    ExactNearness nearness(scene);
    SwapEdge edge = swap_edge_tiers::exact(nearness.of(FacetId(0)), nearness.of(FacetId(1)));
    edge.surfaces = {FacetId(0), FacetId(1)};
    const ExactLine line = exact_line(edge, nearness);
    if (!edge.is_seen) continue;
    ++seen;
    const BigInteger largest = std::max({BigInteger(abs(line.a)), BigInteger(abs(line.b)), BigInteger(abs(line.c))});
    CHECK(share(line.a, largest) == edge.a);
    CHECK(share(line.b, largest) == edge.b);
    CHECK(share(line.c, largest) == edge.c);
  }
  CHECK(seen > 250);
}

}  // namespace sightline::tests::swap_line_test
