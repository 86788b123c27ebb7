// Painters are made of these parts: splitting, Newell's tests, and trees too high to recurse into.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "peers/painters/bsp_tree.h"
#include "peers/painters/depth_sort.h"
#include "peers/scene/newell_tests.h"
#include "peers/scene/polygon_split.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::peer_painters_parts_test {
using namespace peers;

namespace {

FlatPolygon flat_polygon(std::size_t face, const DepthPlane& plane, const std::vector<Point2>& corners) {
  FlatPolygon polygon{FaceId(face), FacetId(face), true, plane, {}};
  for (const Point2& p : corners) polygon.corners.push_back({p.x, p.y, plane.at(p.x, p.y)});
  return polygon;
}

const std::vector<Point2> square{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};

FlatPolygon square_at(std::size_t face, double depth) { return flat_polygon(face, {0, 0, depth}, square); }

FlatScene scene_of(std::vector<FlatPolygon> polygons) { return {nullptr, nullptr, std::move(polygons)}; }

// The doubles have 32 bits, so that every sum and product below is exact.
double random_in_window(std::mt19937_64& engine) { return std::ldexp(static_cast<double>(engine() >> 32), -31) - 1; }

bool is_corner_of(const FlatPolygon& polygon, const Corner& corner) {
  for (const Corner& c : polygon.corners) {
    if (c.x == corner.x && c.y == corner.y && c.depth == corner.depth) return true;
  }
  return false;
}

int corners_shared(const FlatPolygon& a, const FlatPolygon& b) {
  int shared = 0;
  for (const Corner& c : a.corners) shared += is_corner_of(b, c) ? 1 : 0;
  return shared;
}

int pixels_of_one_only(const ItemBuffer& a, const ItemBuffer& b) {
  int count = 0;
  for (int row = 0; row < a.resolution(); ++row) {
    for (int column = 0; column < a.resolution(); ++column) {
      count += a.at(column, row).valid() != b.at(column, row).valid() ? 1 : 0;
    }
  }
  return count;
}

FaceId seen_in_the_middle(const BackToFront& polygons) { return paint(polygons, 8).buffer.at(4, 4); }

}  // namespace

TEST_CASE("parts keep the corners, share those of the cut, and are not cut by the plane again") {
  std::mt19937_64 engine(1972);
  int splits = 0;
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const DepthPlane plane{random_in_window(engine), random_in_window(engine), random_in_window(engine)};
    const FlatPolygon polygon = flat_polygon(0, plane, square);
    const DepthPlane cutting{random_in_window(engine), random_in_window(engine), random_in_window(engine)};
    if (side_of(polygon, cutting) != Side::across) continue;
    ++splits;
    const Halves parts = split(polygon, cutting);
    CHECK(side_of(parts.nearer, cutting) == Side::nearer);
    CHECK(side_of(parts.farther, cutting) == Side::farther);
    CHECK(corners_shared(parts.nearer, parts.farther) == 2);
    CHECK(corners_shared(polygon, parts.nearer) + corners_shared(polygon, parts.farther) == 4);
    const BackToFront both{parts.nearer, parts.farther};
    CHECK(paint(both, 64).pixels_painted == paint({polygon}, 64).pixels_painted);
  }
  CHECK(splits > 300);
}

TEST_CASE("a cut through pixels' centres leaves none of them out and paints none of them twice") {
  const FlatPolygon polygon = flat_polygon(0, {1, 1, 0}, square);
  const Halves parts = split(polygon, {0, 0, 0});
  CHECK(paint({parts.nearer, parts.farther}, 64).pixels_painted == 32 * 32);
}

TEST_CASE("polygons that share an edge are not across each other's planes, whatever rounding does to its corners") {
  std::mt19937_64 engine(1974);
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const double off = std::ldexp(random_in_window(engine), -41);
    const DepthPlane left{random_in_window(engine), 0.1, 0.3};
    const DepthPlane right{1000 * random_in_window(engine), 0.1, 0.3};
    const FlatPolygon at_left = flat_polygon(0, left, {{-1, -1}, {off, -1}, {off, 1}, {-1, 1}});
    CHECK(side_of(at_left, right) != Side::across);
  }
}

TEST_CASE("Newell's tests are what the slides say") {
  const auto surface = [](const FlatPolygon& polygon) { return Surface{polygon, extent_of(polygon.corners)}; };
  const Surface near = surface(square_at(0, 1));
  const Surface far = surface(square_at(1, 2));
  const Surface beside = surface(flat_polygon(2, {0, 0, 1}, {{0.5, 0}, {1, 0}, {1, 1}}));
  const Surface above = surface(flat_polygon(3, {0, 0, 1}, {{0, 0.5}, {1, 0.5}, {1, 1}}));
  const Surface corner = surface(flat_polygon(4, {0, 0, 1}, {{0.25, 0.75}, {0.75, 0.25}, {0.75, 0.75}}));
  CHECK(is_nearer_throughout(near, far));
  CHECK_FALSE(is_nearer_throughout(far, near));
  CHECK_FALSE(is_nearer_throughout(near, beside));
  CHECK(x_extents_apart(near, beside));
  CHECK_FALSE(y_extents_apart(near, beside));
  CHECK(y_extents_apart(near, above));
  CHECK_FALSE(x_extents_apart(near, above));
  CHECK(is_behind(far, near));
  CHECK_FALSE(is_behind(near, far));
  CHECK(is_before(near, far));
  CHECK_FALSE(is_before(far, near));
  CHECK_FALSE(x_extents_apart(near, corner));
  CHECK_FALSE(y_extents_apart(near, corner));
  CHECK(images_apart(near, corner));
  CHECK_FALSE(images_apart(near, far));
}

TEST_CASE("coincident polygons: the lower face index is in front, however they are listed") {
  for (const auto& faces : {std::vector<std::size_t>{0, 1, 2, 3}, {3, 2, 1, 0}, {2, 0, 3, 1}}) {
    for (const DepthPlane& plane : {DepthPlane{0, 0, 1}, DepthPlane{0.3, -7, 0.1}}) {
      std::vector<FlatPolygon> polygons;
      for (const std::size_t face : faces) polygons.push_back(flat_polygon(face, plane, square));
      const DepthSorted sorted = sort_by_depth(scene_of(polygons));
      CHECK(seen_in_the_middle(sorted.polygons) == FaceId(0));
      CHECK(sorted.splits == 0);
      CHECK(seen_in_the_middle(display_bsp(make_bsp(polygons))) == FaceId(0));
    }
  }
}

TEST_CASE("planes about as far apart as the tolerance: sorting ends, and no polygon is lost") {
  std::uint64_t moves = 0;
  std::uint64_t splits = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 engine(seed);
    std::vector<FlatPolygon> polygons;
    for (std::size_t face = 0; face < 60; ++face) {
      const auto about_1 = [&engine] { return 1 + 32 * touching * random_in_window(engine); };
      const double x = 0.5 * random_in_window(engine);
      const double y = 0.5 * random_in_window(engine);
      const DepthPlane plane{about_1(), about_1(), about_1()};
      polygons.push_back(flat_polygon(face, plane, {{x - 0.25, y - 0.25}, {x + 0.5, y}, {x, y + 0.375}}));
    }
    const ItemBuffer all = paint(polygons, 64).buffer;
    const DepthSorted sorted = sort_by_depth(scene_of(polygons));
    CHECK(pixels_of_one_only(all, paint(sorted.polygons, 64).buffer) == 0);
    CHECK(pixels_of_one_only(all, paint(display_bsp(make_bsp(polygons)), 64).buffer) == 0);
    moves += sorted.moves;
    splits += sorted.splits;
  }
  CHECK(moves > 0);
  CHECK(splits > 0);
}

TEST_CASE("a tree from a convex body is a list") {
  std::vector<FlatPolygon> polygons;
  for (std::size_t i = 0; i < 2000; ++i) {
    const double from = static_cast<double>(i) / 1000 - 1;
    const double to = from + 0.001;
    polygons.push_back(flat_polygon(i, {from + to, 0, -from * to}, {{from, -1}, {to, -1}, {to, 1}, {from, 1}}));
  }
  const BspTree tree = make_bsp(polygons);
  CHECK(tree.height == 2000);
  CHECK(tree.splits == 0);
  CHECK(display_bsp(tree).size() == 2000);
}

TEST_CASE("a tree of a million levels is displayed, the farthest first") {
  constexpr std::size_t levels = 1'000'000;
  BspTree tree;
  for (std::size_t i = 0; i < levels; ++i) {
    BspNode node;
    node.root.push_back(square_at(i, static_cast<double>(i)));
    node.viewer_is_in_front = i % 2 == 0;
    if (i + 1 < levels) (node.viewer_is_in_front ? node.back_child : node.front_child) = BspNodeId(i + 1);
    tree.nodes.push_back(std::move(node));
  }
  const BackToFront displayed = display_bsp(tree);
  REQUIRE(displayed.size() == levels);
  CHECK(displayed.front().face == FaceId(levels - 1));
  CHECK(displayed.back().face == FaceId(0));
}

}  // namespace sightline::tests::peer_painters_parts_test
