#include "reconstruct/triangulation/constrained_delaunay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "geometry/numbers/errors.h"

namespace sightline::tests::constrained_delaunay_test {
namespace {

__extension__ using Wide = __int128;

struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

bool sweep_order(const GridPoint& a, const GridPoint& b) { return a.y != b.y ? a.y > b.y : a.x < b.x; }

Wide doubled_area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
}

// This is the in-circle determinant, for coordinates of up to 28 bits.
Sign circle_sign(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  const auto lift = [&](const GridPoint& p) { return Wide(p.x - d.x) * (p.x - d.x) + Wide(p.y - d.y) * (p.y - d.y); };
  return sign_of(lift(a) * doubled_area(d, b, c) + lift(b) * doubled_area(d, c, a) + lift(c) * doubled_area(d, a, b));
}

class GridPoints : public PlanarPoints {
 public:
  explicit GridPoints(std::vector<GridPoint> points) : points_(std::move(points)) {
    std::sort(points_.begin(), points_.end(), sweep_order);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }
  std::size_t size() const override { return points_.size(); }
  Sign orient(PlanarPointId a, PlanarPointId b, PlanarPointId c) const override {
    return sign_of(doubled_area(at(a), at(b), at(c)));
  }
  bool flip_improves(PlanarPointId a, PlanarPointId b, PlanarPointId c, PlanarPointId d) const override {
    return circle_sign(at(a), at(b), at(c), at(d)) > 0;
  }
  const GridPoint& at(PlanarPointId p) const { return points_[p.index()]; }
  PlanarPointId find(const GridPoint& p) const {
    const auto found = std::lower_bound(points_.begin(), points_.end(), p, sweep_order);
    REQUIRE(*found == p);
    return PlanarPointId(static_cast<std::size_t>(found - points_.begin()));
  }

 private:
  std::vector<GridPoint> points_;
};

// The orientation is on a grid, the flips in other coordinates: the same points sheared and rounded to a coarser grid.
class RoundedPoints : public GridPoints {
 public:
  RoundedPoints(std::vector<GridPoint> points, std::int64_t cell) : GridPoints(std::move(points)), cell_(cell) {}
  bool flip_improves(PlanarPointId a, PlanarPointId b, PlanarPointId c, PlanarPointId d) const override {
    return circle_sign(rounded(a), rounded(b), rounded(c), rounded(d)) > 0;
  }
  GridPoint rounded(PlanarPointId p) const {
    return {(3 * at(p).x + at(p).y) / cell_, (2 * at(p).y - at(p).x) / cell_};
  }

 private:
  std::int64_t cell_;
};

class AlwaysFlips : public GridPoints {
 public:
  using GridPoints::GridPoints;
  bool flip_improves(PlanarPointId, PlanarPointId, PlanarPointId, PlanarPointId) const override { return true; }
};

class NeverFlips : public PlanarPoints {
 public:
  explicit NeverFlips(const GridPoints& points) : points_(points) {}
  std::size_t size() const override { return points_.size(); }
  Sign orient(PlanarPointId a, PlanarPointId b, PlanarPointId c) const override { return points_.orient(a, b, c); }

 private:
  const GridPoints& points_;
};

using Random = std::mt19937;

// This is not std::uniform_int_distribution, whose values differ between standard libraries.
std::int64_t below(Random& random, std::int64_t end) {
  return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(end));
}

std::vector<GridPoint> random_points(Random& random, std::int64_t count, std::int64_t width, std::int64_t height) {
  std::vector<GridPoint> points;
  for (std::int64_t i = 0; i < count; ++i) points.push_back({below(random, width), below(random, height)});
  return points;
}

bool strictly_inside(const GridPoint& a, const GridPoint& b, const GridPoint& p) {
  if (p == a || p == b || doubled_area(a, b, p) != 0) return false;
  return (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) < 0;
}

bool cross(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  return sign_of(doubled_area(a, b, c)) * sign_of(doubled_area(a, b, d)) < 0 &&
         sign_of(doubled_area(c, d, a)) * sign_of(doubled_area(c, d, b)) < 0;
}

bool is_allowed(const GridPoints& points, const Constraint& candidate, const std::vector<Constraint>& accepted) {
  const GridPoint& a = points.at(candidate[0]);
  const GridPoint& b = points.at(candidate[1]);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (strictly_inside(a, b, points.at(PlanarPointId(i)))) return false;
  }
  return std::none_of(accepted.begin(), accepted.end(),
                      [&](const Constraint& c) { return cross(a, b, points.at(c[0]), points.at(c[1])); });
}

std::vector<Constraint> random_constraints(Random& random, const GridPoints& points, std::size_t attempts) {
  std::vector<Constraint> accepted;
  for (std::size_t i = 0; i < attempts && points.size() > 1; ++i) {
    const auto n = static_cast<std::int64_t>(points.size());
    const Constraint candidate{PlanarPointId(static_cast<std::size_t>(below(random, n))),
                               PlanarPointId(static_cast<std::size_t>(below(random, n)))};
    if (candidate[0] != candidate[1] && is_allowed(points, candidate, accepted)) accepted.push_back(candidate);
  }
  return accepted;
}

Wide doubled_area(const HalfEdgeTriangulation& mesh, const GridPoints& points, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return doubled_area(points.at(a), points.at(b), points.at(c));
}

Wide doubled_area(const HalfEdgeTriangulation& mesh, const GridPoints& points) {
  Wide sum = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) sum += doubled_area(mesh, points, TriangleId(t));
  return sum;
}

// Andrew's monotone chain goes along the sweep order, first one side and then the other.
Wide doubled_hull_area(const GridPoints& points) {
  std::vector<PlanarPointId> hull;
  const auto add = [&](PlanarPointId p, std::size_t base) {
    while (hull.size() >= base + 2 && points.orient(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  };
  for (std::size_t i = 0; i < points.size(); ++i) add(PlanarPointId(i), 0);
  const std::size_t turn = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(PlanarPointId(i), turn);
  Wide sum = 0;
  for (std::size_t i = 2; i < hull.size(); ++i)
    sum += doubled_area(points.at(hull[0]), points.at(hull[i - 1]), points.at(hull[i]));
  return sum;
}

// Returns whether no constraint crosses or touches the way from the triangle's centroid to p. All coordinates are times
// three.
bool centroid_sees(const std::array<GridPoint, 3>& corners, const GridPoint& p, const GridPoints& points,
                   const std::vector<Constraint>& constraints) {
  const auto tripled = [](const GridPoint& q) { return GridPoint{3 * q.x, 3 * q.y}; };
  const GridPoint centroid{corners[0].x + corners[1].x + corners[2].x, corners[0].y + corners[1].y + corners[2].y};
  const GridPoint target = tripled(p);
  return std::none_of(constraints.begin(), constraints.end(), [&](const Constraint& c) {
    const GridPoint a = tripled(points.at(c[0]));
    const GridPoint b = tripled(points.at(c[1]));
    return cross(a, b, target, centroid) || strictly_inside(target, centroid, a) ||
           strictly_inside(target, centroid, b);
  });
}

// Returns the points strictly inside a triangle's circumcircle that its centroid sees: there are none in a constrained
// Delaunay triangulation.
std::size_t visible_intruders(const HalfEdgeTriangulation& mesh, const GridPoints& points,
                              const std::vector<Constraint>& constraints) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    const std::array<GridPoint, 3> corners{points.at(a), points.at(b), points.at(c)};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const GridPoint& p = points.at(PlanarPointId(i));
      if (circle_sign(corners[0], corners[1], corners[2], p) <= 0) continue;
      if (centroid_sees(corners, p, points, constraints)) ++count;
    }
  }
  return count;
}

bool has_edge(const HalfEdgeTriangulation& mesh, const Constraint& c) {
  for (std::size_t i = 0; i < mesh.origin.size(); ++i) {
    const HalfEdgeId h(i);
    if (Constraint{mesh.from(h), mesh.to(h)} == c || Constraint{mesh.to(h), mesh.from(h)} == c) return true;
  }
  return false;
}

bool has_cocircular_pair(const HalfEdgeTriangulation& mesh, const GridPoints& points) {
  for (std::size_t i = 0; i < mesh.origin.size(); ++i) {
    const HalfEdgeId h(i);
    const HalfEdgeId g = mesh.twin_of(h);
    if (!g.valid()) continue;
    if (circle_sign(points.at(mesh.from(h)), points.at(mesh.to(h)), points.at(mesh.apex(h)), points.at(mesh.apex(g))) ==
        0) {
      return true;
    }
  }
  return false;
}

std::vector<Constraint> closed_polygon(const GridPoints& points, const std::vector<GridPoint>& corners) {
  std::vector<Constraint> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sides.push_back({points.find(corners[i]), points.find(corners[(i + 1) % corners.size()])});
  }
  return sides;
}

Wide doubled_area(const std::vector<GridPoint>& corners) {
  Wide sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += doubled_area({0, 0}, corners[i], corners[(i + 1) % corners.size()]);
  return sum;
}

std::vector<Wide> doubled_region_areas(const HalfEdgeTriangulation& mesh, const GridPoints& points) {
  const Regions regions = flood_regions(mesh);
  std::vector<Wide> areas(regions.count);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    areas[regions.of_triangle[t].index()] += doubled_area(mesh, points, TriangleId(t));
  }
  return areas;
}

}  // namespace

TEST_CASE("constrained Delaunay: random points and segments on small grids") {
  std::size_t all_collinear = 0;
  std::size_t forced = 0;
  std::size_t cocircular = 0;
  std::size_t constraints_made = 0;
  constexpr std::uint32_t scenes = 3000;
  for (std::uint32_t seed = 0; seed < scenes; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const std::int64_t width = 1 + below(random, 9);
    const GridPoints points(random_points(random, 1 + below(random, 30), width, 2 + below(random, 7)));
    const std::vector<Constraint> constraints =
        random_constraints(random, points, seed % 3 == 0 ? 0 : 4 * points.size());
    const HalfEdgeTriangulation mesh = constrained_delaunay(points, constraints);
    REQUIRE(validate(mesh, points, constraints) == std::vector<std::string>{});
    REQUIRE(bool(doubled_area(mesh, points) == doubled_hull_area(points)));
    REQUIRE(visible_intruders(mesh, points, constraints) == 0);
    REQUIRE(mesh == constrained_delaunay(points, constraints));

    if (mesh.triangle_count() == 0) {
      ++all_collinear;
      continue;
    }
    const HalfEdgeTriangulation free = constrained_delaunay(points, {});
    for (const Constraint& c : constraints) forced += has_edge(free, c) ? 0 : 1;
    constraints_made += constraints.size();
    cocircular += has_cocircular_pair(mesh, points) ? 1 : 0;
  }
  CHECK(all_collinear > scenes / 20);
  CHECK(cocircular > scenes / 3);
  CHECK(forced > constraints_made / 10);
}

TEST_CASE("constrained Delaunay: no flips by default, and still every constraint") {
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const GridPoints grid(random_points(random, 40, 12, 12));
    const NeverFlips points(grid);
    const std::vector<Constraint> constraints = random_constraints(random, grid, 200);
    const HalfEdgeTriangulation mesh = constrained_delaunay(points, constraints);
    REQUIRE(validate(mesh, points, constraints) == std::vector<std::string>{});
    REQUIRE(bool(doubled_area(mesh, grid) == doubled_hull_area(grid)));
  }
}

TEST_CASE("constrained Delaunay: the order and direction of constraints does not matter without cocircular points") {
  std::size_t compared = 0;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const GridPoints points(random_points(random, 40, 1 << 20, 1 << 20));
    std::vector<Constraint> constraints = random_constraints(random, points, 60);
    const auto sorted = [](const HalfEdgeTriangulation& mesh) {
      std::vector<std::array<PlanarPointId, 3>> triangles;
      for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        auto corners = mesh.corners(TriangleId(t));
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        triangles.push_back(corners);
      }
      std::sort(triangles.begin(), triangles.end());
      return triangles;
    };
    const HalfEdgeTriangulation mesh = constrained_delaunay(points, constraints);
    REQUIRE(validate(mesh, points, constraints) == std::vector<std::string>{});
    if (has_cocircular_pair(mesh, points)) continue;
    std::reverse(constraints.begin(), constraints.end());
    for (Constraint& c : constraints) std::swap(c[0], c[1]);
    REQUIRE(sorted(mesh) == sorted(constrained_delaunay(points, constraints)));
    ++compared;
  }
  CHECK(compared > 90);
}

TEST_CASE("constrained Delaunay: fewer than three points, and points on one line") {
  const auto triangles = [](std::vector<GridPoint> list) {
    const GridPoints points(std::move(list));
    const std::vector<Constraint> constraints =
        points.size() < 2 ? std::vector<Constraint>{} : std::vector<Constraint>{{PlanarPointId(0), PlanarPointId(1)}};
    const HalfEdgeTriangulation mesh = constrained_delaunay(points, constraints);
    CHECK(validate(mesh, points, constraints) == std::vector<std::string>{});
    return mesh.triangle_count();
  };
  CHECK(triangles({}) == 0);
  CHECK(triangles({{0, 0}}) == 0);
  CHECK(triangles({{0, 0}, {1, 2}}) == 0);
  CHECK(triangles({{0, 0}, {1, 2}, {2, 4}, {5, 10}}) == 0);
  CHECK(triangles({{0, 0}, {1, 0}, {2, 0}}) == 0);
  CHECK(triangles({{0, 0}, {1, 0}, {0, 1}}) == 1);
  CHECK(triangles({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, -7}}) == 3);
  CHECK(triangles({{0, 0}, {0, 1}, {0, 2}, {0, 3}, {-7, -1}}) == 3);
}

TEST_CASE("constrained Delaunay: nested squares are regions of their own") {
  constexpr std::int64_t rings = 12;
  std::vector<GridPoint> corners;
  for (std::int64_t r = 1; r <= rings; ++r) corners.insert(corners.end(), {{-r, -r}, {r, -r}, {r, r}, {-r, r}});
  const GridPoints points(corners);
  std::vector<Constraint> constraints;
  std::vector<Wide> expected;
  for (std::int64_t r = 1; r <= rings; ++r) {
    const auto side = closed_polygon(points, {{-r, -r}, {r, -r}, {r, r}, {-r, r}});
    constraints.insert(constraints.end(), side.begin(), side.end());
    expected.push_back(2 * (4 * r * r - 4 * (r - 1) * (r - 1)));
  }
  const HalfEdgeTriangulation mesh = constrained_delaunay(points, constraints);
  REQUIRE(validate(mesh, points, constraints) == std::vector<std::string>{});
  std::vector<Wide> areas = doubled_region_areas(mesh, points);
  std::sort(areas.begin(), areas.end());
  CHECK(bool(areas == expected));
}

TEST_CASE("constrained Delaunay: a thin zigzag, as one polygon") {
  // Its upper side is its lower side moved up by 1; most of its sides cross many edges of what was there before.
  constexpr std::int64_t teeth = 40;
  const auto lower = [](std::int64_t i) { return GridPoint{5 * i, i % 2 == 0 ? 0 : 1000}; };
  std::vector<GridPoint> corners;
  for (std::int64_t i = 0; i <= 2 * teeth; ++i) corners.push_back(lower(i));
  for (std::int64_t i = 2 * teeth; i >= 0; --i) corners.push_back({lower(i).x, lower(i).y + 1});
  const GridPoints points(corners);
  const std::vector<Constraint> constraints = closed_polygon(points, corners);
  const HalfEdgeTriangulation mesh = constrained_delaunay(points, constraints);
  REQUIRE(validate(mesh, points, constraints) == std::vector<std::string>{});
  const std::vector<Wide> areas = doubled_region_areas(mesh, points);
  // The regions are the inside, a bay below each tooth, and a bay above each gap between two teeth. The two ends are on
  // the hull.
  CHECK(areas.size() == 1 + teeth + (teeth - 1));
  CHECK(std::count(areas.begin(), areas.end(), doubled_area(corners)) == 1);
}

TEST_CASE("constrained Delaunay: a polyline that hangs into the cavity of a constraint") {
  // The vertices above the long constraint are joined by constraints that end freely near it.
  std::vector<GridPoint> list{{-1000, 0}, {1000, 0}};
  for (std::int64_t i = -9; i <= 9; ++i)
    list.insert(list.end(), {{100 * i, 400}, {100 * i + 3, 2}, {100 * i, -400}, {100 * i + 3, -2}});
  const GridPoints points(list);
  std::vector<Constraint> constraints;
  for (std::int64_t i = -9; i <= 9; ++i) {
    constraints.push_back({points.find({100 * i, 400}), points.find({100 * i + 3, 2})});
    constraints.push_back({points.find({100 * i, -400}), points.find({100 * i + 3, -2})});
  }
  constraints.push_back({points.find({-1000, 0}), points.find({1000, 0})});
  CHECK_FALSE(has_edge(constrained_delaunay(points, std::span(constraints).first(38)), constraints.back()));
  const HalfEdgeTriangulation mesh = constrained_delaunay(points, constraints);
  CHECK(validate(mesh, points, constraints) == std::vector<std::string>{});
  CHECK(visible_intruders(mesh, points, constraints) == 0);
}

TEST_CASE("constrained Delaunay: flips in rounded coordinates that contradict the orientation") {
  std::size_t turned_over = 0;
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    const RoundedPoints points(random_points(random, 3 + below(random, 60), 64, 64), 1 + below(random, 16));
    const std::vector<Constraint> constraints = random_constraints(random, points, 40);
    const HalfEdgeTriangulation mesh = constrained_delaunay(points, constraints);
    REQUIRE(validate(mesh, points, constraints) == std::vector<std::string>{});
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(t));
      turned_over += doubled_area(points.rounded(a), points.rounded(b), points.rounded(c)) < 0 ? 1 : 0;
    }
  }
  CHECK(turned_over > 1000);
}

TEST_CASE("constrained Delaunay: a flip test that breaks its contract cannot keep it from ending") {
  Random random(5);
  const std::vector<GridPoint> list = random_points(random, 40, 30, 30);
  const AlwaysFlips points(list);
  const GridPoints grid(list);
  const NeverFlips judge(grid);
  const std::vector<Constraint> constraints = random_constraints(random, points, 30);
  CHECK(validate(constrained_delaunay(points, constraints), judge, constraints) == std::vector<std::string>{});
}

TEST_CASE("constrained Delaunay: constraints that break the precondition are refused") {
  const GridPoints points({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {9, 1}, {9, 3}});
  const auto edge = [&](GridPoint a, GridPoint b) { return Constraint{points.find(a), points.find(b)}; };
  CHECK_THROWS_AS((void)constrained_delaunay(points, std::vector{edge({0, 0}, {4, 4})}), InternalError);
  CHECK_THROWS_AS((void)constrained_delaunay(points, std::vector{edge({4, 0}, {4, 4}), edge({2, 2}, {9, 1})}),
                  InternalError);
  CHECK_THROWS_AS((void)constrained_delaunay(points, std::vector{edge({2, 2}, {9, 1}), edge({4, 4}, {4, 0})}),
                  InternalError);
}

TEST_CASE("constrained Delaunay: a constraint that meets a point only after it has crossed an edge is refused") {
  const GridPoints points({{0, 0}, {2, 1}, {2, -1}, {4, 0}, {6, 1}, {6, -1}, {8, 0}});
  const Constraint through{points.find({0, 0}), points.find({8, 0})};
  CHECK_THROWS_WITH_AS((void)constrained_delaunay(points, std::vector{through}),
                       doctest::Contains("runs through a point"), ConstraintConflict);
}

TEST_CASE("constrained Delaunay: validate finds what is broken") {
  Random random(11);
  const GridPoints points(random_points(random, 30, 100, 100));
  const std::vector<Constraint> constraints = random_constraints(random, points, 30);
  const HalfEdgeTriangulation good = constrained_delaunay(points, constraints);
  REQUIRE(validate(good, points, constraints) == std::vector<std::string>{});
  const auto is_found = [&](auto breaks) {
    HalfEdgeTriangulation mesh = good;
    breaks(mesh);
    return !validate(mesh, points, constraints).empty();
  };
  CHECK(is_found([](auto& mesh) { std::swap(mesh.origin[0], mesh.origin[1]); }));
  CHECK(is_found([](auto& mesh) { mesh.origin[0] = PlanarPointId(mesh.origin.size()); }));
  CHECK(is_found([](auto& mesh) { mesh.twin[4] = mesh.twin[5]; }));
  CHECK(is_found([](auto& mesh) { mesh.twin.pop_back(); }));
  CHECK(is_found([](auto& mesh) { mesh = {}; }));
  CHECK(is_found([](auto& mesh) { std::fill(mesh.twin.begin(), mesh.twin.end(), HalfEdgeId{}); }));
  for (std::size_t h = 0; h < good.origin.size(); ++h) {
    CHECK(is_found([&](auto& mesh) { mesh.constrained[h] ^= 1; }));
  }
  CHECK_FALSE(validate(constrained_delaunay(points, {}), points, constraints).empty());
  CHECK_FALSE(validate(constrained_delaunay(NeverFlips(points), constraints), points, constraints).empty());
}

TEST_CASE("constrained Delaunay: many points") {
  Random random(3);
  const GridPoints points(random_points(random, 100000, 1 << 20, 1 << 20));
  std::vector<GridPoint> corners;
  for (std::size_t i = 0; i < 1000; ++i) corners.push_back(points.at(PlanarPointId(100 * i)));
  // Joined in sweep order the polyline crosses nothing; random points are in general position but for few.
  std::vector<Constraint> constraints;
  for (std::size_t i = 1; i < corners.size(); ++i)
    constraints.push_back({PlanarPointId(100 * (i - 1)), PlanarPointId(100 * i)});
  const HalfEdgeTriangulation mesh = constrained_delaunay(points, constraints);
  CHECK(validate(mesh, points, constraints) == std::vector<std::string>{});
  CHECK(bool(doubled_area(mesh, points) == doubled_hull_area(points)));
}

TEST_CASE("constrained Delaunay: a full grid") {
  std::vector<GridPoint> list;
  for (std::int64_t x = 0; x < 200; ++x) {
    for (std::int64_t y = 0; y < 200; ++y) list.push_back({x, y});
  }
  const GridPoints points(list);
  const HalfEdgeTriangulation mesh = constrained_delaunay(points, {});
  CHECK(validate(mesh, points, {}) == std::vector<std::string>{});
  CHECK(mesh.triangle_count() == 2 * 199 * 199);
}

}  // namespace sightline::tests::constrained_delaunay_test
