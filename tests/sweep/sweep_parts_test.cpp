// The parts of the sweep are tested by themselves: crossing points, the active edge list, node lists.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "geometry/projection/projected_scene.h"
#include "sweep/plain/active_edge_list.h"
#include "sweep/plain/depth_order.h"
#include "sweep/plain/node_list.h"
#include "sweep/plain/sweep.h"
#include "sweep/segments/crossing_point.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::sweep_parts_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;

constexpr unsigned seed = 42;

Exact exact_y(const CrossingPoint& c) {
  return Exact(c.base.y) + Exact(BigInteger(c.offset_y)) / Exact(BigInteger(c.denominator));
}
Exact exact_x(const CrossingPoint& c) {
  return Exact(c.base.x) + Exact(BigInteger(c.offset_x)) / Exact(BigInteger(c.denominator));
}

int rational_order(const CrossingPoint& a, const CrossingPoint& b) {
  if (exact_y(a) != exact_y(b)) return exact_y(a) > exact_y(b) ? -1 : 1;
  if (exact_x(a) != exact_x(b)) return exact_x(a) < exact_x(b) ? -1 : 1;
  return 0;
}

ImagePoint random_point(std::mt19937& random, std::int64_t size) {
  std::uniform_int_distribution<std::int64_t> coordinate(-size, size);
  return {coordinate(random), coordinate(random)};
}

// Returns two edges that cross, end by end.
std::array<ImagePoint, 4> crossing_edges(std::mt19937& random, std::int64_t size) {
  while (true) {
    const ImagePoint a = random_point(random, size);
    const ImagePoint b = random_point(random, size);
    const ImagePoint c = random_point(random, size);
    const ImagePoint d = random_point(random, size);
    const bool cross =
        orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
    if (cross) return {a, b, c, d};
  }
}

CrossingPoint random_crossing(std::mt19937& random, std::int64_t size) {
  const auto [a, b, c, d] = crossing_edges(random, size);
  return crossing_point(a, b, c, d);
}

// Returns parallel squares facing +z, the higher face in front of the lower for an eye far up z.
Mesh stack(const std::vector<double>& heights) {
  std::vector<Point3> vertices;
  PolygonList faces;
  for (const double z : heights) {
    const std::size_t first = vertices.size();
    vertices.insert(vertices.end(), {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
    faces.push_back(std::array{VertexId(first), VertexId(first + 1), VertexId(first + 2), VertexId(first + 3)});
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

Camera from_above() { return orthographic_camera("above", {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 4); }

}  // namespace

TEST_CASE("crossing points: order and rounding, against rationals, at both ends of the grid") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  int equal = 0;
  for (const std::int64_t size : {std::int64_t{1}, std::int64_t{3}, std::int64_t{1} << 40}) {
    for (int i = 0; i < 1500; ++i) {
      const CrossingPoint a = random_crossing(random, size);
      const CrossingPoint b = random_crossing(random, size);
      CAPTURE(i);
      CHECK(sweep_compare(a, b) == rational_order(a, b));
      CHECK(crossing_tiers::exact(a, b) == rational_order(a, b));
      equal += rational_order(a, b) == 0 ? 1 : 0;
      CHECK(abs(Exact(a.x) - exact_x(a)) <= Exact(crossing_error));
      CHECK(abs(Exact(a.y) - exact_y(a)) <= Exact(crossing_error));
      const ImagePoint p = random_point(random, size);
      const CrossingPoint at_p{p, 0, 0, 1, 0, 0};
      CHECK(sweep_compare(a, p) == rational_order(a, at_p));
    }
  }
  CHECK(equal > 20);
}

TEST_CASE("the height of a crossing is the crossing's y") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 1000; ++i) {
    const auto [a, b, c, d] = crossing_edges(random, std::int64_t{1} << 40);
    CHECK(crossing_height(a, b, c, d) == crossing_point(a, b, c, d).y);
  }
}

TEST_CASE("a crossing does not depend on the order of its edges") {
  const ImagePoint a{0, 10};
  const ImagePoint b{7, -3};
  const ImagePoint c{5, 9};
  const ImagePoint d{-2, -4};
  CHECK(sweep_compare(crossing_point(a, b, c, d), crossing_point(c, d, a, b)) == 0);
}

TEST_CASE("the active edge list against a plain list: order, search, nearest visible") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  ActiveEdgeList active(1);
  std::vector<BundleId> plain;
  const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  int nearest_found = 0;
  for (int step = 0; step < 4000; ++step) {
    CAPTURE(step);
    const bool insert = plain.empty() || pick(5) < 3;
    if (insert) {
      const std::size_t place = pick(plain.size() + 1);
      const BundleId b = active.insert_after(place == 0 ? BundleId{} : plain[place - 1]);
      plain.insert(plain.begin() + static_cast<std::ptrdiff_t>(place), b);
      if (pick(4) == 0) active[b].left_segment.segment = SegmentId(0);
      active.visibility_changed(b);
    } else {
      const std::size_t place = pick(plain.size());
      active.erase(plain[place]);
      plain.erase(plain.begin() + static_cast<std::ptrdiff_t>(place));
    }
    REQUIRE(active.empty() == plain.empty());
    if (plain.empty()) continue;
    CHECK(active.first() == plain.front());
    CHECK(active.last() == plain.back());
    const std::size_t place = pick(plain.size());
    CHECK(active.next(plain[place]) == (place + 1 < plain.size() ? plain[place + 1] : BundleId{}));
    CHECK(active.previous(plain[place]) == (place > 0 ? plain[place - 1] : BundleId{}));
    const auto left_of = [&](const Bundle& bundle) {
      for (std::size_t i = 0; i < place; ++i) {
        if (&active[plain[i]] == &bundle) return true;
      }
      return false;
    };
    CHECK(active.find(left_of) == plain[place]);
    BundleId nearest;
    for (std::size_t i = 0; i < place; ++i) nearest = active[plain[i]].visible() ? plain[i] : nearest;
    CHECK(active.nearest_visible_before(plain[place]) == nearest);
    nearest_found += nearest.valid() ? 1 : 0;
  }
  CHECK(nearest_found > 500);
}

TEST_CASE("a crossing counts once, however often its edges become neighbours") {
  // Two bars cross, and between their upper ends a small triangle parts their edges for a while.
  const std::vector<tests::Corners> bars{{{-6, 6, 0}, {-4, 6, 0}, {5, -6, 0}}, {{6, 6, 1}, {4, 6, 1}, {-5, -6, 1}}};
  std::vector<tests::Corners> parted = bars;
  parted.push_back({{-0.5, 5, 2}, {0.5, 5, 2}, {0, 4.5, 2}});
  const Camera camera = orthographic_camera("above", {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 16);
  for (const std::vector<tests::Corners>& surface : {bars, parted}) {
    const Mesh mesh = tests::mesh_of(surface);
    const VisibleSegments segments = plain_sweep(project(mesh, camera, Sides::both));
    CHECK(segments.statistics.crossings == 4);
  }
}

TEST_CASE("node lists: the same contents and the same topmost facet whatever the way") {
  const Mesh mesh = stack({0, 1, 2});
  const ProjectedScene scene = project(mesh, from_above(), Sides::both);
  DepthOrder depth(scene);
  const auto enter = [](std::size_t f) { return EdgeSide{FacetId(f), 1, MeshEdgeId{}}; };
  const auto leave = [](std::size_t f) { return EdgeSide{FacetId(f), -1, MeshEdgeId{}}; };
  NodeList list;
  CHECK_FALSE(list.topmost().valid());
  list.cross(std::array{enter(1), enter(0)}, depth);
  CHECK(list.topmost() == FacetId(1));
  list.cross(std::array{enter(2)}, depth);
  CHECK(list.topmost() == FacetId(2));
  NodeList other;
  other.cross(std::array{enter(0)}, depth);
  other.cross(std::array{enter(2), enter(1)}, depth);
  CHECK(list.same_contents(other));
  other.cross(std::array{leave(2)}, depth);
  CHECK(other.topmost() == FacetId(1));
  CHECK_FALSE(list.same_contents(other));
  // A facet that the rounding has turned over leaves before it enters.
  NodeList turned;
  turned.cross(std::array{leave(0)}, depth);
  CHECK(turned.topmost() == FacetId(0));
  turned.cross(std::array{enter(0)}, depth);
  CHECK_FALSE(turned.topmost().valid());
  CHECK(turned.same_contents(NodeList{}));
  // A facet with both of its sides on one bundle is not there; one that leaves and one that enters trade places.
  turned.cross(std::array{enter(2), enter(1), leave(2)}, depth);
  CHECK(turned.topmost() == FacetId(1));
  turned.cross(std::array{enter(0), leave(1)}, depth);
  CHECK(turned.topmost() == FacetId(0));
  CHECK(turned.nodes().size() == 1);
  // What sides lead to is told without going there.
  CHECK(turned.leads_to(NodeList{}, std::array{leave(0)}));
  CHECK_FALSE(turned.leads_to(NodeList{}, std::array{enter(0)}));
  CHECK_FALSE(turned.leads_to(NodeList{}, {}));
  CHECK(turned.leads_to(list, std::array{enter(1), enter(2)}));
}

TEST_CASE("a facet that is smaller than the grid is a sweep point without edges, alone and over another facet") {
  const tests::Corners speck{{0.3, 0.7, 1}, {0.3005, 0.7, 1}, {0.3, 0.7005, 1}};
  const tests::Corners below{{-1, -1, 0}, {1, -1, 0}, {0, 1.5, 0}};
  const Precision coarse{Arithmetic::exact, smallest_grid_bits};
  const Mesh alone = tests::mesh_of({speck});
  const ProjectedScene point = project(alone, from_above(), Sides::both, coarse);
  REQUIRE(point.points.size() == 1);
  REQUIRE(point.edge_count() == 0);
  const VisibleSegments nothing = plain_sweep(point);
  CHECK(nothing.statistics.sweep_points == 1);
  CHECK(nothing.segments.empty());
  const Mesh both = tests::mesh_of({speck, below});
  const ProjectedScene scene = project(both, from_above(), Sides::both, coarse);
  REQUIRE(scene.points.size() == 4);
  const VisibleSegments segments = plain_sweep(scene);
  CHECK(segments.statistics.sweep_points == 4);
  CHECK(segments.segments.size() == 3);
}

TEST_CASE("node lists: of bars that overlap in a ring the lowest is topmost, and of two of them the nearer one") {
  // Each bar rises along a side of a triangle and lies on the next one's lower end; the last one rises most.
  const std::array<Point3, 3> ring{Point3{4, 0, 0}, Point3{-2, 3, 0}, Point3{-2, -3, 0}};
  // Under them lies a plate.
  std::vector<tests::Corners> bars{{{-10, -10, -2}, {10, -10, -2}, {0, 12, -2}}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 along = ring[(i + 1) % 3] - ring[i];
    const Vector3 across{-0.03 * along.y(), 0.03 * along.x(), 0};
    const Point3 low = ring[i] - 0.25 * along - Vector3{0, 0, 0.25};
    const double rise = 1.25 + 0.05 * static_cast<double>(i);
    const Point3 high = ring[i] + rise * along + Vector3{0, 0, rise};
    bars.push_back({low, high - across, high + across});
  }
  const Mesh mesh = tests::mesh_of(bars);
  const Camera camera = orthographic_camera("above", {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 16);
  const ProjectedScene scene = project(mesh, camera, Sides::both);
  const auto side = [](std::size_t f, int winding) { return EdgeSide{FacetId(f), winding, MeshEdgeId{}}; };
  for (const std::vector<DepthRange>& ranges : {std::vector<DepthRange>{}, depth_ranges(scene)}) {
    DepthOrder depth(scene, ranges);
    for (std::size_t i = 0; i < 3; ++i) REQUIRE(depth.nearer(FacetId(1 + i), FacetId(1 + (i + 1) % 3)));
    for (std::size_t first = 0; first < 3; ++first) {
      CAPTURE(first);
      NodeList list;
      list.cross(std::array{side(0, 1)}, depth);
      for (std::size_t i = 0; i < 3; ++i) list.cross(std::array{side(1 + (first + i) % 3, 1)}, depth);
      CHECK(list.topmost() == FacetId(1));
      CHECK_FALSE(list.is_topmost_nearest());
      list.cross(std::array{side(1 + first, -1)}, depth);
      CHECK(list.topmost() == FacetId(1 + (first + 1) % 3));
      CHECK(list.is_topmost_nearest());
    }
  }
}

}  // namespace sightline::tests::sweep_parts_test
