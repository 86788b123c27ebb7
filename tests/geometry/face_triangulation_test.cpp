// Polygons that touch themselves are triangulated, and held against the law of areas and a winding number counted point
// by point.
#include "geometry/faces/face_triangulation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <random>

#include "geometry/mesh/mesh.h"

namespace sightline::tests::face_triangulation_test {
namespace {

// The polygon has vertices on a small integer grid in z = 0. Corners at one place are one vertex.
struct GridPolygon {
  std::vector<Point3> vertices;
  std::vector<VertexId> corners;

  [[nodiscard]] PolygonView view() const { return {corners, vertices}; }
};

// Returns twice the signed area, exactly for small integers.
double doubled_area(std::span<const VertexId> corners, std::span<const Point3> vertices) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point3& a = vertices[corners[i].index()];
    const Point3& b = vertices[corners[(i + 1) % corners.size()].index()];
    area += a.x() * b.y() - a.y() * b.x();
  }
  return area;
}

double doubled_area(const std::vector<Triangle>& triangles, std::span<const Point3> vertices) {
  double area = 0;
  for (const Triangle& t : triangles) area += doubled_area(t, vertices);
  return area;
}

class GridRandom {
 public:
  GridRandom(unsigned seed, std::size_t side) : random_(seed), side_(side) {}

  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_); }

  // Returns the grid's points, in random order.
  std::vector<Point3> shuffled_grid() {
    std::vector<Point3> points;
    for (std::size_t i = 0; i < side_ * side_; ++i)
      points.push_back({static_cast<double>(i % side_), static_cast<double>(i / side_), 0});
    std::ranges::shuffle(points, random_);
    return points;
  }
  std::mt19937_64& engine() { return random_; }

 private:
  std::mt19937_64 random_;
  std::size_t side_;
};

const FaceView from_above{{0, 0, 1}, {}, {}};

// Ears are put on instead of clipped: each new triangle stands outside on an edge and overlaps no other, so the
// boundary is weakly simple; on a small grid it soon touches itself in points and along edges, and closes round holes.
struct GrownPolygon {
  GridPolygon polygon;
  std::vector<Triangle> triangles;
};

GrownPolygon grow_polygon(GridRandom& random, std::size_t attempts) {
  GrownPolygon grown{{random.shuffled_grid(), {}}, {}};
  const std::vector<Point3>& vertices = grown.polygon.vertices;
  std::vector<VertexId>& corners = grown.polygon.corners;
  const auto random_vertex = [&] { return VertexId(random.below(vertices.size())); };
  const auto turn = [&](const Triangle& t) {
    return from_above.turn(vertices[t[0].index()], vertices[t[1].index()], vertices[t[2].index()]);
  };
  Triangle first{random_vertex(), random_vertex(), random_vertex()};
  while (turn(first) <= 0) first = {random_vertex(), random_vertex(), random_vertex()};
  corners.assign(first.begin(), first.end());
  grown.triangles.push_back(first);
  for (std::size_t i = 0; i < attempts; ++i) {
    const std::size_t edge = random.below(corners.size());
    const Triangle ear{corners[edge], random_vertex(), corners[(edge + 1) % corners.size()]};
    if (turn(ear) <= 0) continue;
    grown.triangles.push_back(ear);
    if (!interiors_disjoint(from_above, grown.triangles, vertices))
      grown.triangles.pop_back();
    else
      corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(edge) + 1, ear[1]);
  }
  return grown;
}

bool has_repeated_vertex(std::vector<VertexId> corners) {
  std::ranges::sort(corners);
  return std::ranges::adjacent_find(corners) != corners.end();
}

std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  std::ranges::sort(triangles);
  return triangles;
}

std::vector<Triangle> reversed(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::ranges::reverse(t);
  return triangles;
}

// The plane is slanted, so that no coordinate can be dropped without thought: x and y change places with z = 2x + 3y.
std::vector<Point3> on_slanted_plane(std::vector<Point3> vertices) {
  for (Point3& p : vertices) p = {p.y(), 2 * p.x() + 3 * p.y(), p.x()};
  return vertices;
}

TEST_CASE("polygons that touch themselves are covered once") {
  constexpr unsigned seed = 7;
  GridRandom random(seed, 5);
  std::size_t touching = 0;
  for (int run = 0; run < 2000; ++run) {
    INFO("seed " << seed << ", run " << run);
    GrownPolygon grown = grow_polygon(random, 120);
    GridPolygon& polygon = grown.polygon;
    touching += has_repeated_vertex(polygon.corners) ? 1 : 0;
    remove_spikes(polygon.corners, polygon.vertices);
    const auto triangles = triangulate(polygon.view());
    REQUIRE(triangles);
    CHECK(triangles->size() == polygon.corners.size() - 2);
    CHECK(interiors_disjoint(from_above, *triangles, polygon.vertices));
    CHECK(doubled_area(*triangles, polygon.vertices) == doubled_area(grown.triangles, polygon.vertices));
  }
  CHECK(touching > 1000);
}

TEST_CASE("the first corner, the direction and the plane do not matter") {
  constexpr unsigned seed = 8;
  GridRandom random(seed, 5);
  for (int run = 0; run < 300; ++run) {
    INFO("seed " << seed << ", run " << run);
    GridPolygon polygon = grow_polygon(random, 30).polygon;
    remove_spikes(polygon.corners, polygon.vertices);
    const auto triangles = triangulate(polygon.view());
    REQUIRE(triangles);
    std::vector<VertexId> corners = polygon.corners;
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(random.below(corners.size())),
                corners.end());
    CHECK(sorted(*triangulate({corners, polygon.vertices})) == sorted(*triangles));
    std::ranges::reverse(corners);
    CHECK(sorted(*triangulate({corners, polygon.vertices})) == sorted(reversed(*triangles)));
    CHECK(*triangulate({polygon.corners, on_slanted_plane(polygon.vertices)}) == *triangles);
  }
}

// Returns how often the polygon goes round a point given in units of 1 / scale, counted along a ray to the right;
// nullopt if the point is on it.
std::optional<int> winding_number(const GridPolygon& polygon, std::int64_t x, std::int64_t y, std::int64_t scale) {
  int winding = 0;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Point3& a = polygon.view()[i];
    const Point3& b = polygon.view()[i + 1];
    const std::int64_t ax = static_cast<std::int64_t>(a.x()) * scale - x;
    const std::int64_t ay = static_cast<std::int64_t>(a.y()) * scale - y;
    const std::int64_t bx = static_cast<std::int64_t>(b.x()) * scale - x;
    const std::int64_t by = static_cast<std::int64_t>(b.y()) * scale - y;
    const std::int64_t side = ax * by - ay * bx;
    if (side == 0 && std::min(ax, bx) <= 0 && std::max(ax, bx) >= 0 && std::min(ay, by) <= 0 && std::max(ay, by) >= 0)
      return std::nullopt;
    if (ay <= 0 && by > 0 && side > 0) ++winding;
    if (ay > 0 && by <= 0 && side < 0) --winding;
  }
  return winding;
}

// Returns whether all sample points have winding number 0 or 1 in the polygon's direction.
bool goes_round_once(const GridPolygon& polygon, int side, double area) {
  constexpr std::int64_t scale = 2 * 29;
  for (std::int64_t y = 1; y < side * scale; y += 2) {
    for (std::int64_t x = 1; x < side * scale; x += 2) {
      const int winding = winding_number(polygon, x, y, scale).value_or(0) * (area > 0 ? 1 : -1);
      if (winding != 0 && winding != 1) return false;
    }
  }
  return area != 0;
}

TEST_CASE("random polygons are divided if they go round once everywhere, and only then") {
  constexpr unsigned seed = 9;
  constexpr int side = 4;
  GridRandom random(seed, side);
  std::size_t divided = 0;
  std::size_t pinched = 0;
  for (int run = 0; run < 1500; ++run) {
    INFO("seed " << seed << ", run " << run);
    GridPolygon polygon{random.shuffled_grid(), {}};
    const std::size_t size = 4 + random.below(5);
    for (std::size_t i = 0; i < size; ++i) polygon.corners.emplace_back(random.below(polygon.vertices.size()));
    remove_spikes(polygon.corners, polygon.vertices);
    if (polygon.corners.size() < 3) continue;
    const double area = doubled_area(polygon.corners, polygon.vertices);
    const auto triangles = triangulate(polygon.view());
    CHECK(triangles.has_value() == goes_round_once(polygon, side - 1, area));
    if (!triangles) continue;
    ++divided;
    pinched += triangles->size() < polygon.corners.size() - 2 ? 1 : 0;
    CHECK(doubled_area(*triangles, polygon.vertices) == area);
  }
  CHECK(divided > 150);
  CHECK(pinched > 0);
}

TEST_CASE("a convex quad that is not planar is split by the diagonal that misses its highest vertex") {
  const std::vector<Point3> vertices{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  const std::vector<VertexId> corners{VertexId(2), VertexId(3), VertexId(0), VertexId(1)};
  const auto triangles = triangulate({corners, vertices});
  REQUIRE(triangles);
  CHECK(sorted(*triangles) ==
        sorted({{VertexId(2), VertexId(3), VertexId(0)}, {VertexId(0), VertexId(1), VertexId(2)}}));
}

TEST_CASE("coordinates may be as large, as small and as far apart as doubles are") {
  for (const double unit : {1e300, 1.0, 1e-300, 5e-324}) {
    INFO("unit " << unit);
    const std::vector<Point3> concave{{0, 0, 0}, {4 * unit, 0, 0}, {unit, unit, 0}, {0, 4 * unit, 0}};
    const std::vector<VertexId> corners{VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
    const auto triangles = triangulate({corners, concave});
    REQUIRE(triangles);
    CHECK(triangles->size() == 2);
  }
  const std::vector<Point3> long_and_thin{{0, 0, 0}, {1e300, 0, 0}, {1e300, 1e-300, 1e-305}, {0, 1e-300, 0}};
  const std::vector<VertexId> corners{VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
  CHECK(triangulate({corners, long_and_thin}).value().size() == 2);
}

TEST_CASE("a polygon without area, or one that crosses itself out of its plane, has no triangles") {
  const std::vector<Point3> vertices{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 1}};
  const auto polygon = [](std::initializer_list<std::size_t> ids) {
    std::vector<VertexId> corners;
    for (const std::size_t id : ids) corners.emplace_back(id);
    return corners;
  };
  const std::vector<VertexId> bowtie = polygon({0, 1, 2, 3});
  CHECK_FALSE(triangulate({bowtie, vertices}).has_value());
  const std::vector<VertexId> lifted_bowtie = polygon({0, 1, 2, 4});
  CHECK_FALSE(triangulate({lifted_bowtie, vertices}).has_value());
}

}  // namespace

}  // namespace sightline::tests::face_triangulation_test
