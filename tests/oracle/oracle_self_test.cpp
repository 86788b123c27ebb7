// The oracle itself is tested on scenes whose answer is known by hand, and against a second way to compute it.
#include <doctest/doctest.h>

#include "oracle/judging/judge.h"
#include "oracle/lattice/pair_relation.h"

namespace sightline::tests::oracle_self_test {
using namespace lattice;

namespace {

// This is the plane nearness = n everywhere.
Plane level(std::int64_t nearness) { return {0, 0, 1, -nearness}; }

Ring box(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

const Rational window = Rational(4) * half_window * half_window;

Camera looking_down_z() {
  Camera camera;
  camera.projection = Projection::perspective;
  camera.right = {0.5, 0, 0};
  camera.up = {0, 0.5, 0};
  camera.forward = {0, 0, -1};
  camera.eye = {camera.origin, 1};
  return camera;
}

std::vector<CameraPoint> seen_by(const Camera& camera, const std::vector<Point3>& corners) {
  std::vector<CameraPoint> result;
  for (const Point3& p : corners) result.push_back(to_camera_space(camera, p));
  return result;
}

Rational signed_area(const Ring& ring) {
  Rational twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint& p = ring[i];
    const GridPoint& q = ring[(i + 1) % ring.size()];
    twice += Rational(p.x * q.y - q.x * p.y);
  }
  return twice / 2;
}

}  // namespace

TEST_CASE("the nearer of two squares hides the other where they overlap") {
  const lattice::Visibility v = visibility({{0, box(0, 0, 10, 10), level(1)}, {1, box(5, 5, 15, 15), level(2)}}, 2);
  CHECK(v.area[0] == 75);
  CHECK(v.area[1] == 100);
  CHECK(v.uncovered == window - 175);
}

TEST_CASE("of coplanar faces the lower number is in front, whatever the order in the list") {
  const lattice::Visibility v = visibility({{1, box(0, 0, 10, 10), level(1)}, {0, box(5, 5, 15, 15), level(1)}}, 2);
  CHECK(v.area[0] == 100);
  CHECK(v.area[1] == 75);
}

TEST_CASE("slanted edges give exact rational areas") {
  const Ring up{{0, 0}, {6, 0}, {3, 7}};
  const Ring down{{0, 5}, {3, -2}, {6, 5}};
  const lattice::Visibility v = visibility({{0, up, level(1)}, {1, down, level(2)}}, 2);
  CHECK(v.area[1] == 21);
  // The overlap is the hexagon left when `up` loses its three tips: the top one is similar by (7 - 5) / 7; the two at
  // the base, by symmetry, end where the edges 7 x = 3 y and 7 x = 15 - 3 y cross, at y = 5 / 2, and where `down` meets
  // y = 0, at x = 15 / 7.
  const Rational top = Rational(21) * Rational(4, 49);
  const Rational tip = Rational(15, 7) * Rational(5, 2) / 2;
  CHECK(v.area[0] == top + 2 * tip);
}

TEST_CASE("towers of slabs add up to the area of the ring") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    INFO("seed ", seed);
    const RandomScene scene = random_scene(seed);
    const Mesh mesh = mesh_of(scene);
    for (const OracleFace& face : oracle_faces(mesh, scene.camera, scene.sides)) {
      OracleFace alone = face;
      alone.number = 0;
      const Rational area = signed_area(face.ring);
      CHECK(visibility({alone}, 1).area[0] == (area < 0 ? Rational(-area) : area));
    }
  }
}

TEST_CASE("visible areas and the uncovered area fill the window") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    INFO("seed ", seed);
    const RandomScene scene = random_scene(seed);
    const Mesh mesh = mesh_of(scene);
    const lattice::Visibility v = visibility(oracle_faces(mesh, scene.camera, scene.sides), mesh.face_count());
    Rational sum = v.uncovered;
    for (const Rational& area : v.area) sum += area;
    CHECK(sum == window);
  }
}

TEST_CASE("nearness over a slanted plane is 1 / W of a pinhole") {
  const auto corners = seen_by(looking_down_z(), {{0, 0, -1}, {2, 0, -2}, {0, 2, -2}});
  const auto plane = plane_of(corners);
  REQUIRE(plane);
  for (const CameraPoint& p : corners) CHECK(side(*plane, p) == 0);
  // The image of (1, 1, -2), the middle of two corners, is (1/4, 1/4) of the half window; the levels are in units of 1
  // / W = 1 / 256 / 256.
  const Place place{half_window / 4, half_window / 4, 1};
  const auto at_depth = [](const Point3& p) {
    return plane_of(seen_by(looking_down_z(), {p, p + Vector3{1, 0, 0}, p + Vector3{0, 1, 0}}));
  };
  CHECK(nearer(*plane, *at_depth({0, 0, -2}), place) == 0);
  CHECK(nearer(*plane, *at_depth({0, 0, -1}), place) < 0);
  CHECK(nearer(*plane, *at_depth({0, 0, -4}), place) > 0);
}

TEST_CASE("facing: counter-clockwise seen from the eye is front, also where a corner is behind the eye") {
  const Camera camera = looking_down_z();
  CHECK(facing(seen_by(camera, {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}})) == 1);
  CHECK(facing(seen_by(camera, {{0, 0, -1}, {0, 1, -1}, {1, 0, -1}})) == -1);
  CHECK(facing(seen_by(camera, {{1, -1, -2}, {-1, -1, -2}, {0, -1, 3}})) == 1);
  CHECK(facing(seen_by(camera, {{0, 0, -1}, {0, 0, -2}, {1, 0, -1}})) == 0);
}

TEST_CASE("a floor that passes below the eye is clipped to a trapezoid that reaches the window's lower corners") {
  // The floor is y = -1 between x = -1 and 1, from behind the eye to depth 2: in the image it is up to y = -1/4, and
  // there x = -1/4 .. 1/4.
  const auto floor = seen_by(looking_down_z(), {{-1, -1, -2}, {-1, -1, 2}, {1, -1, 2}, {1, -1, -2}});
  const auto ring = clipped_image_of(floor);
  REQUIRE(ring);
  const Rational area = signed_area(*ring);
  const Rational h = half_window;
  CHECK((area < 0 ? Rational(-area) : area) == (Rational(2) + Rational(1, 2)) / 2 * Rational(3, 4) * h * h);
}

TEST_CASE("crossing, touching and coplanar pairs are told apart") {
  const auto placed = [](const std::vector<Point3>& corners) {
    PlacedFace face;
    face.corners = seen_by(looking_down_z(), corners);
    face.plane = *plane_of(face.corners);
    face.image = *image_of(face.corners);
    face.whole = true;
    return face;
  };
  const PlacedFace wall = placed({{-2, -2, -2}, {2, -2, -2}, {0, 2, -2}});
  CHECK(relation(wall, placed({{-1, -1, -1}, {4, -4, -4}, {1, 1, -1}})) == Relation::crossing);
  CHECK(relation(wall, placed({{0, 0, -2}, {1, 0, -1}, {0, 1, -1}})) == Relation::ordered);
  CHECK(relation(wall, placed({{0, 0, -2}, {4, 0, -2}, {0, 4, -2}})) == Relation::coplanar);
  CHECK(relation(wall, placed({{2, 2, -1}, {1, 2, -1}, {2, 1, -1}})) == Relation::separate);
}

TEST_CASE("a seed gives one scene") {
  CHECK(to_text(random_scene(1)) == to_text(random_scene(1)));
  CHECK(to_text(random_scene(1)) != to_text(random_scene(2)));
}

}  // namespace sightline::tests::oracle_self_test
