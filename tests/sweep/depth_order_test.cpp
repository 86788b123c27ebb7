// This tests which of two faces is in front: by their planes, where they straddle these by what the eye sees, and ties
// by index.
#include "sweep/plain/depth_order.h"

#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "geometry/cutting/common_lines.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::depth_order_test {
namespace {

constexpr unsigned seed = 42;

Camera from_above(double window) {
  return orthographic_camera("above", {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, window);
}

Camera at_origin(const Point3& target) {
  return perspective_camera("eye", {{0, 0, 0}, target, {0, 1, 0}, 1, {}, {}}, 90);
}

Corners square_at(double z) { return {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}}; }

// Returns where the ray from the origin meets the polygon, in multiples of the direction; 0 where it does not.
double distance_along(const Vector3& direction, const Corners& polygon) {
  int left = 0;
  int right = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double side = direction.dot(polygon[i].cross(polygon[(i + 1) % polygon.size()]));
    left += side > 0 ? 1 : 0;
    right += side < 0 ? 1 : 0;
  }
  const Vector3 normal = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[0]);
  const double distance = polygon[0].dot(normal) / direction.dot(normal);
  const bool is_met = std::max(left, right) == static_cast<int>(polygon.size());
  return is_met && distance > 0 ? distance : 0;
}

}  // namespace

TEST_CASE("depth: the nearer of parallel faces, whichever way they are asked; ties go to the lower face") {
  const Mesh mesh = tests::mesh_of({square_at(0), square_at(1), square_at(0.5), square_at(std::nextafter(1.0, 2.0))});
  const ProjectedScene scene = project(mesh, from_above(4), Sides::both);
  DepthOrder depth(scene);
  const std::vector<FacetId> front_to_back{FacetId(3), FacetId(1), FacetId(2), FacetId(0)};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      CHECK(depth.nearer(front_to_back[i], front_to_back[j]));
      CHECK_FALSE(depth.nearer(front_to_back[j], front_to_back[i]));
    }
  }
}

TEST_CASE("depth: faces that straddle each other's planes without meeting have an order") {
  // Two bars cross in the image, one above the other, both tilted so that each plane cuts the other bar.
  const Mesh mesh =
      tests::mesh_of({{{-4, -0.5, 3}, {4, 0, -1}, {-4, 0.5, 3}}, {{-0.5, -4, -3}, {0.5, -4, -3}, {0, 4, 2}}});
  const ProjectedScene scene = project(mesh, from_above(16), Sides::both);
  DepthOrder depth(scene);
  CHECK(depth.nearer(FacetId(0), FacetId(1)));
  CHECK_FALSE(depth.nearer(FacetId(1), FacetId(0)));
}

TEST_CASE("depth: faces that straddle each other's planes and show no common place are ordered by index") {
  // They are side by side, sloping to the front and to the back.
  const Corners left{{-3, -1, -1}, {-1, 0, 0}, {-3, 1, 1}};
  const Corners right{{3, -1, 1}, {1, 0, 0}, {3, 1, -1}};
  for (const bool left_first : {true, false}) {
    const Mesh mesh = tests::mesh_of(left_first ? std::vector{left, right} : std::vector{right, left});
    const ProjectedScene scene = project(mesh, from_above(4), Sides::both);
    DepthOrder depth(scene);
    CHECK(depth.nearer(FacetId(0), FacetId(1)));
    CHECK_FALSE(depth.nearer(FacetId(1), FacetId(0)));
  }
}

TEST_CASE("depth: of large faces around the eye, as rays have it") {
  std::mt19937_64 random(seed);
  const auto coordinate = [&] { return static_cast<double>(random() % 17) - 8; };
  const auto place = [&]() { return Point3{coordinate(), coordinate(), coordinate()}; };
  const Camera camera = at_origin({0, 0, 1});
  int compared = 0;
  for (int pair = 0; pair < 20000; ++pair) {
    const Corners first{place(), place(), place()};
    const Corners second{place(), place(), place()};
    const Vector3 direction{coordinate() / 8.5, coordinate() / 8.5, 1};
    const double of_first = distance_along(direction, first);
    const double of_second = distance_along(direction, second);
    if (of_first == 0 || of_second == 0 || std::fabs(of_first - of_second) < 1e-9) continue;
    const Mesh mesh = tests::mesh_of({first, second});
    if (mesh.facet_count() != 2 || !find_contacts(mesh).crossing.empty()) continue;
    const ProjectedScene scene = project(mesh, camera, Sides::both);
    DepthOrder depth(scene);
    ++compared;
    CAPTURE(pair);
    CHECK(depth.nearer(FacetId(0), FacetId(1)) == (of_first < of_second));
  }
  MESSAGE("seed " << seed << ", " << compared << " pairs on a common ray");
  CHECK(compared > 50);
}

// The faces overlap in a triangle of the image, whose corners are three places that show the order. Elsewhere four
// lines through the eye meet an edge of one face on one side of the eye and an edge of the other on the other side.
// These say nothing of the order; taken for places where edges cross, they would outvote the three.
TEST_CASE("depth: of faces that reach around the eye, edges that cross behind it are no evidence") {
  const Corners quadrilateral{{-7, 1, -8}, {1, 8, -12}, {2, -2, 2}, {-7, -5, 0}};
  const Corners triangle{{2, 6, 0}, {9, 8, 14}, {2, -6, 0}};
  const Vector3 direction{4, -4, 1};
  REQUIRE(distance_along(direction, quadrilateral) > 0);
  REQUIRE(distance_along(direction, quadrilateral) < distance_along(direction, triangle));
  for (const bool near_first : {true, false}) {
    const Mesh mesh =
        tests::mesh_of(near_first ? std::vector{quadrilateral, triangle} : std::vector{triangle, quadrilateral});
    REQUIRE(mesh.facet_count() == 2);
    REQUIRE(find_contacts(mesh).crossing.empty());
    const ProjectedScene scene = project(mesh, at_origin(direction), Sides::both);
    DepthOrder depth(scene);
    CHECK(depth.nearer(FacetId(0), FacetId(1)) == near_first);
  }
}

TEST_CASE("depth: pieces of faces that pass through each other are in front on one side each") {
  const Mesh whole =
      tests::mesh_of({{{-1, -1, -0.3}, {1, -1, 0.4}, {0, 1, 0}}, {{-1, 1, 0.3}, {1, 1, -0.4}, {0, -1, 0.1}}});
  const CutMesh mesh = cut_along_common_lines(whole, find_contacts(whole));
  REQUIRE(mesh.facet_count() == 4);
  const ProjectedScene scene = project(mesh, from_above(4), Sides::both);
  DepthOrder depth(scene);
  int first_in_front = 0;
  for (const FacetId f : {FacetId(0), FacetId(1)}) {
    for (const FacetId g : {FacetId(2), FacetId(3)}) {
      CHECK(depth.nearer(f, g) != depth.nearer(g, f));
      first_in_front += depth.nearer(f, g) ? 1 : 0;
    }
  }
  CHECK(first_in_front == 2);
}

}  // namespace sightline::tests::depth_order_test
