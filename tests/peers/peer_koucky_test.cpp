// Koucky's retriangulation is right within its limits, and wrong by known areas outside them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "oracle/judging/judge.h"
#include "oracle/lattice/lattice.h"
#include "oracle/scenes/random_scenes.h"
#include "peers/painters/delaunay.h"
#include "peers/painters/koucky.h"
#include "tests/peers/peer_parts.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::peer_koucky_test {
namespace {

using lattice::Dice;
using peers::delaunay;
using peers::koucky;
using peers::TriangleOfPoints;

constexpr double tolerance = 1e-9;

// Seen from above the triangle is right-angled at its left lower corner; the third side is on x + y = 0. Its area is
// 1.125.
const Corners triangle{{-0.75, -0.75, 0}, {0.75, -0.75, 0}, {-0.75, 0.75, 0}};

Corners rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom, 1}, {right, bottom, 1}, {right, top, 1}, {left, top, 1}};
}

PartsCase seen_from_above(const std::vector<Corners>& polygons) {
  return parts_case(koucky(), mesh_of(polygons), straight_down());
}

Point3 anywhere(Dice& dice, double height) {
  const double x = dice.between(-63, 63) / 64.0;
  return {x, dice.between(-63, 63) / 64.0, height};
}

Corners triangle_anywhere(Dice& dice, double height) {
  const Point3 a = anywhere(dice, height);
  const Point3 b = anywhere(dice, height + dice.between(-2, 2) / 8.0);
  return {a, b, anywhere(dice, height)};
}

// Returns the error for a table of squares, each two triangles, under a bar.
double error_under_bar(int squares) {
  std::vector<Corners> polygons{{{-0.8, -0.33, 1}, {-0.7, -0.41, 1}, {0.8, 0.31, 1}, {0.7, 0.43, 1}}};
  const auto place = [&](int i) { return 1.5 * i / squares - 0.75; };
  for (int i = 0; i < squares; ++i) {
    for (int j = 0; j < squares; ++j) {
      const Point3 corner{place(i), place(j), 0};
      const Point3 across{place(i + 1), place(j + 1), 0};
      polygons.push_back({corner, {across.x(), corner.y(), 0}, across});
      polygons.push_back({corner, across, {corner.x(), across.y(), 0}});
    }
  }
  const PartsCase parts = seen_from_above(polygons);
  double error = 0;
  for (std::size_t f = 0; f < parts.seen.size(); ++f) error += std::abs(parts.seen[f] - parts.exact[f]);
  return error;
}

}  // namespace

TEST_CASE("koucky: an occluder with a vertex inside, before one corner") {
  const PartsCase parts = seen_from_above({triangle, rectangle(-1, -1, -0.25, -0.25)});
  CHECK(parts.seen[0] == doctest::Approx(1.125 - 0.25));
  CHECK(largest_error(parts) <= tolerance);
  CHECK(overlap_within_faces(parts.parts) <= tolerance);
  CHECK(number_of(parts, "triangles partly visible") == 1);
}

TEST_CASE("koucky: the border of what hides is one straight line across the triangle") {
  std::size_t cases = 0;
  for (std::uint64_t seed = 1; cases < 500; ++seed) {
    INFO("seed ", seed);
    REQUIRE(seed < 20000);
    Dice dice(seed);
    const Corners behind = triangle_anywhere(dice, 0);
    const PartsCase parts = seen_from_above({behind, triangle_anywhere(dice, 2)});
    if (number_of(parts, "triangles partly visible") != 1 || number_of(parts, "points added") != 2) continue;
    ++cases;
    CHECK(largest_error(parts) <= tolerance);
    CHECK(overlap_within_faces(parts.parts) <= tolerance);
    CHECK(parts.seen[0] > 0);
  }
}

TEST_CASE("koucky: the second triangulation keeps no point that only hidden triangles have") {
  std::vector<Corners> polygons{triangle};
  for (int i = 0; i < 8; ++i) polygons.push_back(rectangle(-0.75 + i / 16.0, -1, -0.6875 + i / 16.0, -0.25));
  const PartsCase parts = seen_from_above(polygons);
  CHECK(largest_error(parts) <= tolerance);
  const std::uint64_t of_strips = 2 * 8;
  const std::uint64_t points = 3 + 9 + 1;  // corners, the strips' upper ends, the last one's right side
  const std::uint64_t on_border = 5;
  CHECK(number_of(parts, "triangles") == of_strips + 2 * points - 2 - on_border);
}

TEST_CASE("koucky: an occluder with no vertex inside that hides no corner is missed") {
  const PartsCase parts = seen_from_above({triangle, rectangle(-0.25, -1, 0, 1)});
  CHECK(parts.seen[0] == 1.125);
  CHECK(parts.exact[0] == doctest::Approx(1.125 - 0.25 * (0.75 + 1) / 2));
  CHECK(number_of(parts, "triangles partly visible") == 0);
}

TEST_CASE("koucky: an occluder before the middle is missed") {
  const PartsCase parts = seen_from_above({triangle, rectangle(-0.5, -0.5, -0.25, -0.25)});
  CHECK(parts.seen[0] == 1.125);
  CHECK(parts.exact[0] == doctest::Approx(1.125 - 0.0625));
}

TEST_CASE("koucky: an occluder before the middle is missed where the triangle is retriangulated, too") {
  const PartsCase parts = seen_from_above({triangle, rectangle(-1, 0.25, 1, 1), rectangle(-0.5, -0.5, -0.25, -0.25)});
  CHECK(number_of(parts, "triangles partly visible") == 1);
  CHECK(parts.seen[0] - parts.exact[0] == doctest::Approx(0.0625));
}

TEST_CASE("koucky: what is seen between three hidden corners is missed") {
  const PartsCase parts = seen_from_above(
      {triangle, rectangle(-1, -1, -0.5, -0.5), rectangle(0.5, -1, 1, -0.5), rectangle(-1, 0.5, -0.5, 1)});
  CHECK(parts.seen[0] == 0);
  CHECK(parts.exact[0] == doctest::Approx(1.125 - 0.0625 - 2 * 0.03125));
}

TEST_CASE("koucky: a triangle of the unconstrained Delaunay triangulation lies across an occluder's edge") {
  const Corners obtuse{{-0.75, -0.5, 0}, {0, -0.5, 0}, {0.75, 0.25, 0}};
  const Corners spike{{-0.95, -0.45, 1}, {-0.95, -0.7, 1}, {0.3, -0.15, 1}};
  const PartsCase parts = seen_from_above({obtuse, spike});
  CHECK(number_of(parts, "triangles partly visible") == 1);
  CHECK(number_of(parts, "points added") == 3);
  CHECK(std::abs(parts.seen[0] - parts.exact[0]) > 0.01);
  CHECK(std::abs(parts.seen[1] - parts.exact[1]) <= tolerance);
}

TEST_CASE("koucky: no point is put where two occluders cross inside the triangle") {
  const Corners rising{{-1, -0.5, 1}, {1, -0.75, 1}, {1, -1, 1}, {-1, -1, 1}};
  const Corners falling{{-1, -1, 2}, {-0.625, -1, 2}, {-0.25, 1, 2}, {-1, 1, 2}};
  const PartsCase parts = seen_from_above({triangle, rising, falling});
  CHECK(number_of(parts, "triangles partly visible") == 1);
  CHECK(std::abs(parts.seen[0] - parts.exact[0]) > 0.01);
}

TEST_CASE("koucky: the smaller the triangles are, the smaller is the error") {
  const double coarse = error_under_bar(2);
  const double middle = error_under_bar(8);
  const double fine = error_under_bar(32);
  MESSAGE("errors under a bar: " << coarse << ", " << middle << ", " << fine);
  CHECK(middle < coarse);
  CHECK(fine < middle / 20);
}

TEST_CASE("koucky: on random scenes the parts of a face do not overlap") {
  std::uint64_t scenes = 0;
  std::uint64_t partly = 0;
  std::uint64_t right = 0;
  for (std::uint64_t seed = 1; scenes < lattice::scene_count(300); ++seed) {
    INFO("seed ", seed);
    const lattice::RandomScene scene = lattice::random_scene(seed);
    if (scene.notes.not_planar) continue;  // the images of such a face's facets may overlap
    ++scenes;
    const PartsCase parts = parts_case(koucky(), lattice::cut(mesh_of(scene)), scene.camera, scene.sides);
    CHECK(overlap_within_faces(parts.parts) <= tolerance);
    partly += number_of(parts, "triangles partly visible");
    right += largest_error(parts) <= tolerance ? 1 : 0;
  }
  MESSAGE(right << " of " << scenes << " scenes are right; " << partly << " triangles were retriangulated");
  CHECK(partly > lattice::scene_count(300) / 2);
  CHECK(right > 0);
}

TEST_CASE("delaunay: no point is inside the circle of a triangle, and the hull is covered once") {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    INFO("seed ", seed);
    Dice dice(seed);
    std::vector<Point2> points{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
    for (int i = dice.between(0, 24); i > 0; --i)
      points.push_back({dice.between(-8, 8) / 4.0, dice.between(-8, 8) / 4.0});
    double twice_area = 0;
    for (const TriangleOfPoints& t : delaunay(points)) {
      twice_area += (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
      CHECK(std::none_of(points.begin(), points.end(),
                         [&](const Point2& p) { return in_circle(t[0], t[1], t[2], p) > 0; }));
    }
    CHECK(twice_area == 32);
  }
}

TEST_CASE("delaunay: points on one line make no triangle") {
  CHECK(delaunay({{0, 0}, {1, 1}, {2, 2}, {1, 1}}).empty());
}

}  // namespace sightline::tests::peer_koucky_test
