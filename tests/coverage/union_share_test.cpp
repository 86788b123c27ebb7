// The union of triangles on a surface is tested by hand, and by what must not matter to it.
#include "coverage/union_share.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::union_share_test {
namespace {

const Corners square{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};

using Triangles = std::vector<SpaceTriangle>;

Triangles halves(double left, double bottom, double right, double top) {
  return {{Point3{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}},
          {Point3{left, bottom, 0}, {right, top, 0}, {left, top, 0}}};
}

Triangles joined(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// `map` goes from the plane z = 0 to anywhere.
template <class Map>
UnionShare mapped_share(const Triangles& triangles, Map map) {
  Corners surface = square;
  for (Point3& p : surface) p = map(p);
  Triangles mapped = triangles;
  for (SpaceTriangle& t : mapped) {
    for (Point3& p : t) p = map(p);
  }
  return union_share(uncrossed(mesh_of({surface})), FacetId(0), mapped);
}

UnionShare share(const Triangles& triangles) {
  return mapped_share(triangles, [](const Point3& p) { return p; });
}

void check_share(const UnionShare& found, double expected) {
  CHECK(std::fabs(found.share - expected) <= found.error);
  CHECK(found.error < 1e-9);
}

const Triangles overlapping = joined(halves(0, 0, 2, 2), halves(1, 1, 3, 3));

}  // namespace

TEST_CASE("a union is no sum") {
  CHECK(share({}).share == 0);
  check_share(share(halves(0, 0, 2, 2)), 4.0 / 16);
  check_share(share(overlapping), 7.0 / 16);
  check_share(share(joined(overlapping, halves(0, 0, 4, 4))), 1);
  // Thirds are not on the grid.
  const double third = 4.0 / 3;
  check_share(share(joined(halves(0, 0, third, 4), halves(third, 0, 2 * third, 4))), 2.0 / 3);
}

TEST_CASE("orientation, order, repetition, and triangles without area do not matter") {
  Triangles triangles = joined(overlapping, overlapping);
  for (std::size_t i = 0; i < triangles.size(); i += 3) std::swap(triangles[i][0], triangles[i][1]);
  triangles.push_back({Point3{1, 1, 0}, {1, 1, 0}, {4, 1, 0}});
  triangles.push_back({Point3{0, 0, 0}, {2, 2, 0}, {4, 4, 0}});
  std::ranges::reverse(triangles);
  CHECK(share(triangles).share == share(overlapping).share);
}

TEST_CASE("a triangle narrower than the grid adds no more than the bound") {
  const Point3 end{4, std::ldexp(1.0, -45), 0};
  check_share(share(joined(overlapping, {{Point3{0, 0, 0}, {4, 0, 0}, end}})), 7.0 / 16);
}

TEST_CASE("corners that rounding has moved off the surface come back to it") {
  check_share(share(halves(-1e-15, 0, 2, 4 + 1e-15)), 0.5);
}

TEST_CASE("the share is the same at every scale, far away, in every plane") {
  for (const double scale : {0x1p-1060, 0x1p-500, 1.0, 0x1p500, 0x1p1020}) {
    CAPTURE(scale);
    check_share(mapped_share(overlapping, [&](const Point3& p) -> Vector3 { return scale * p; }), 7.0 / 16);
    check_share(mapped_share(overlapping,
                             [&](const Point3& p) -> Vector3 {
                               return scale * Point3{p.y(), p.x() - p.y(), p.x()};
                             }),
                7.0 / 16);
  }
  check_share(mapped_share(overlapping,
                           [](const Point3& p) -> Vector3 {
                             return p + Point3{1e9, -1e9, 1e9};
                           }),
              7.0 / 16);
  check_share(mapped_share(overlapping, [](const Point3& p) { return Point3{1e9, p.x(), p.y() / 1024}; }), 7.0 / 16);
  check_share(mapped_share(overlapping,
                           [](const Point3& p) {
                             return Point3{0x1p1022 * (p.x() - 2), p.y(), p.x()};
                           }),
              7.0 / 16);
}

TEST_CASE("on a needle the bound is wider, and holds") {
  for (const int bits : {4, 10, 20, 30}) {
    CAPTURE(bits);
    const double width = std::ldexp(1.0, -bits);
    // The needle lies along the diagonal, so that it fills little of its rectangle.
    const auto needle = [&](const Point3& p) { return Point3{p.x() + width * p.y(), p.x() - width * p.y(), 0}; };
    const UnionShare found = mapped_share(overlapping, needle);
    CHECK(std::fabs(found.share - 7.0 / 16) <= found.error);
    CHECK(found.error <= std::ldexp(1.0, bits - 30));
  }
}

// Strips go from bottom to top: their union is known from their ends.
TEST_CASE("the bound holds on random strips") {
  const unsigned seed = std::random_device{}();
  MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 4);
  double largest = 0;
  for (int round = 0; round < 300; ++round) {
    Triangles triangles;
    std::vector<std::array<double, 2>> strips;
    for (int i = 0; i < 6; ++i) {
      std::array<double, 2> strip{place(random), place(random)};
      std::ranges::sort(strip);
      strips.push_back(strip);
      triangles = joined(triangles, halves(strip[0], 0, strip[1], 4));
    }
    std::ranges::sort(strips);
    double expected = 0;
    double reached = 0;
    for (const auto& [left, right] : strips) {
      expected += std::max(right, reached) - std::max(left, reached);
      reached = std::max(right, reached);
    }
    const UnionShare found = share(triangles);
    check_share(found, expected / 4);
    largest = std::max(largest, std::fabs(found.share - expected / 4) / found.error);
  }
  MESSAGE("at most " << largest << " of the bound");
  CHECK(largest > 0);
}

}  // namespace sightline::tests::union_share_test
