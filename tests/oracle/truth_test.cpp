// The rational oracle itself is held against the integer oracle of the tests, and tested on scenes whose answer is
// known by hand.
#include <doctest/doctest.h>

#include <algorithm>

#include "oracle/judging/judge.h"
#include "oracle/truth/truth.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::truth_test {
using namespace oracle;
using namespace lattice;

namespace {

// The camera looks along -z. A pinhole at the origin sees |x|, |y| <= -z; the other camera |x|, |y| <= 1.
Camera looking_down_z(Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  camera.forward = {0, 0, -1};
  camera.eye = {camera.origin, 1};
  if (projection == Projection::orthographic) camera.eye = {{0, 0, 1}, 0};
  return camera;
}

const Camera pinhole = looking_down_z(Projection::perspective);
const Camera parallel = looking_down_z(Projection::orthographic);

Rational total(const Truth& truth) {
  Rational sum = truth.uncovered;
  for (const Rational& area : truth.visible_area) sum += area;
  return sum;
}

// Both oracles see one scene; the integers' unit is half_window.
void check_same(const RandomScene& scene) {
  const Mesh mesh = mesh_of(scene);
  const Truth truth = true_visibility(mesh, scene.camera, scene.sides);
  const lattice::Visibility integers = visibility(oracle_faces(mesh, scene.camera, scene.sides), mesh.face_count());
  const Rational unit = Rational(1) / half_window / half_window;
  CHECK(total(truth) == 4);
  CHECK(truth.uncovered == integers.uncovered * unit);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) CHECK(truth.visible_area[f] == integers.area[f] * unit);
}

// Returns a rectangle in the plane z = depth + slope * x.
Corners slope_over_x(double x0, double y0, double x1, double y1, double depth, double slope) {
  return {{x0, y0, depth + slope * x0},
          {x1, y0, depth + slope * x1},
          {x1, y1, depth + slope * x1},
          {x0, y1, depth + slope * x0}};
}

std::vector<RationalPoint> rectangle(const Rational& x0, const Rational& y0, const Rational& x1, const Rational& y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Rational wrong(const Mesh& mesh, const std::vector<Claim>& claims) {
  return compare(mesh, parallel, Sides::both, claims).mislabelled_area;
}

}  // namespace

TEST_CASE("without faces that cross, the rational oracle says what the integer oracle says") {
  for (std::uint64_t seed = 1; seed <= scene_count(500); ++seed) {
    INFO("seed ", seed);
    check_same(random_scene(seed));
  }
}

TEST_CASE("nothing to see: no faces, and faces that are all edge-on") {
  const Truth nothing = true_visibility(tests::mesh_of({}), pinhole, Sides::both);
  CHECK(nothing.visible_area.empty());
  CHECK(nothing.uncovered == 4);
  const Mesh edge_on = tests::mesh_of({{{0, 0, -1}, {1, 0, -1}, {0, 0, -2}}, {{0, -1, -3}, {0, 1, -3}, {0, 0, -1}}});
  CHECK(true_visibility(edge_on, pinhole, Sides::both).uncovered == 4);
}

TEST_CASE("two crossing rectangles, seen in parallel: each is visible on its side of the common line") {
  // The second passes through the first, z = -2, where -2 + x - 1/4 = -2: right of x = 1/4 it is nearer.
  const Mesh mesh =
      tests::mesh_of({slope_over_x(-0.5, -0.5, 0.5, 0.5, -2, 0), slope_over_x(-1, -0.25, 1, 0.25, -2.25, 1)});
  const Truth truth = true_visibility(mesh, parallel, Sides::both);
  CHECK(truth.visible_area[0] == 1 - Rational(1, 4) * Rational(1, 2));
  CHECK(truth.visible_area[1] == (2 - Rational(3, 4)) / 2);
  CHECK(total(truth) == 4);
}

TEST_CASE("two crossing rectangles, seen in perspective: the common line's image is not at the middle") {
  // At z = -2 the first is |x|, |y| <= 1, in the image 1/2. The second is z = -2 + x / 2 from x = -1 (z = -5/2, image x
  // = -2/5) to x = 1 (z = -3/2, image x = 2/3), and passes through the first at x = 0. It is y = 0 .. 1 deep: its image
  // is from y = 0 to 1 / -z, where image x is s: z = -2 + s (-z) / 2, 1 / -z = (2 + s) / 4.
  const Mesh mesh = tests::mesh_of({slope_over_x(-1, -1, 1, 1, -2, 0), slope_over_x(-1, 0, 1, 1, -2, 0.5)});
  const Truth truth = true_visibility(mesh, pinhole, Sides::both);
  const auto integral = [](const Rational& s) { return Rational((2 * s + s * s / 2) / 4); };
  CHECK(truth.visible_area[1] == integral(Rational(2, 3)));
  // The second lies before the first's image up to x = 1/2 and y = 1/2, and is over all of that.
  CHECK(truth.visible_area[0] == 1 - Rational(1, 2) * Rational(1, 2));
  CHECK(total(truth) == 4);
}

TEST_CASE("a triangle through a square, and a triangle that ends inside it") {
  const Corners square = slope_over_x(-0.5, -0.5, 0.5, 0.5, -2, 0);
  const Mesh through = tests::mesh_of({square, {{-0.5, -0.5, -3}, {0.5, -0.5, -3}, {0, 0.5, -1}}});
  const Truth upper_half = true_visibility(through, parallel, Sides::both);
  CHECK(upper_half.visible_area[0] == Rational(7, 8));
  CHECK(upper_half.visible_area[1] == Rational(1, 8));
  // Its tip is behind; at x = 0, where it passes through, it is half as wide as at its end, x = 1/4.
  const Mesh inside = tests::mesh_of({square, {{0.25, -0.25, -1}, {0.25, 0.25, -1}, {-0.25, 0, -3}}});
  const Truth right_half = true_visibility(inside, parallel, Sides::both);
  CHECK(right_half.visible_area[0] == 1 - Rational(3, 32));
  CHECK(right_half.visible_area[1] == Rational(3, 32));
  CHECK(total(right_half) == 4);
}

TEST_CASE("three squares that cross each other in one point") {
  // The planes are z = -2, -2 + x and -2 + y.
  const Mesh mesh = tests::mesh_of({slope_over_x(-0.5, -0.5, 0.5, 0.5, -2, 0),
                                    slope_over_x(-0.5, -0.5, 0.5, 0.5, -2, 1),
                                    {{-0.5, -0.5, -2.5}, {0.5, -0.5, -2.5}, {0.5, 0.5, -1.5}, {-0.5, 0.5, -1.5}}});
  const Truth truth = true_visibility(mesh, parallel, Sides::both);
  CHECK(truth.visible_area[0] == Rational(1, 4));
  CHECK(truth.visible_area[1] == Rational(3, 8));
  CHECK(truth.visible_area[2] == Rational(3, 8));
  CHECK(truth.uncovered == 3);
}

TEST_CASE("squares through one axis: the steepest is in front, on either side") {
  const auto square = [](double slope) { return slope_over_x(-0.5, -0.5, 0.5, 0.5, -2, slope); };
  const Truth two = true_visibility(tests::mesh_of({square(1), square(-1)}), parallel, Sides::both);
  CHECK(two.visible_area == std::vector<Rational>{Rational(1, 2), Rational(1, 2)});
  const Truth three = true_visibility(tests::mesh_of({square(1), square(-1), square(2)}), parallel, Sides::both);
  CHECK(three.visible_area == std::vector<Rational>{0, Rational(1, 2), Rational(1, 2)});
}

TEST_CASE("coplanar faces: the lower index is in front") {
  const Mesh mesh = tests::mesh_of({slope_over_x(0, 0, 1, 1, -2, 0.5), slope_over_x(-1, -1, 0.5, 0.5, -2, 0.5)});
  const Truth truth = true_visibility(mesh, parallel, Sides::both);
  CHECK(truth.visible_area == std::vector<Rational>{1, 2});
}

TEST_CASE("front sides only: a back-facing face is neither seen nor in the way") {
  Corners back = slope_over_x(-0.5, -0.5, 0.5, 0.5, -1, 0);
  std::swap(back[1], back[3]);
  const Mesh mesh = tests::mesh_of({slope_over_x(-0.5, -0.5, 0.5, 0.5, -2, 0), back});
  CHECK(true_visibility(mesh, parallel, Sides::front).visible_area == std::vector<Rational>{1, 0});
  CHECK(true_visibility(mesh, parallel, Sides::both).visible_area == std::vector<Rational>{0, 1});
}

TEST_CASE("near and far planes cut; what lies in one is out of view") {
  const Mesh mesh = tests::mesh_of({slope_over_x(-0.5, -0.5, 0.5, 0.5, -2, 1), slope_over_x(-1, -1, 0, 0, -1.75, 0),
                                    slope_over_x(-1, -1, 0, 0, -2.25, 0)});
  Camera camera = parallel;
  camera.near_distance = 1.75;
  camera.far_distance = 2.25;
  CHECK(true_visibility(mesh, camera, Sides::both).visible_area == std::vector<Rational>{Rational(1, 2), 0, 0});
  // In perspective the floor y = -1 is seen from its near end at -z = 2, image y = -1/2, to -z = 4, y = -1/4.
  const Mesh floor = tests::mesh_of({{{-8, -1, 0}, {8, -1, 0}, {8, -1, -8}, {-8, -1, -8}}});
  Camera eye = pinhole;
  eye.near_distance = 2;
  eye.far_distance = 4;
  CHECK(true_visibility(floor, eye, Sides::both).visible_area == std::vector<Rational>{Rational(1, 2)});
}

TEST_CASE("a floor that passes below the eye is clipped at the window") {
  // The floor is y = -1 between x = -1 and 1, from behind the eye to -z = 2: in the image it is from y = -1, where |x|
  // <= 1, to y = -1/2, where |x| <= 1/2.
  const Mesh floor = tests::mesh_of({{{-1, -1, -2}, {-1, -1, 2}, {1, -1, 2}, {1, -1, -2}}});
  CHECK(true_visibility(floor, pinhole, Sides::both).visible_area == std::vector<Rational>{Rational(3, 4)});
}

TEST_CASE("a face that is not planar counts by facets") {
  // It is folded along a diagonal: one facet is behind a square, the free corner of the other in front of it.
  const Mesh mesh = tests::mesh_of({slope_over_x(-0.5, -0.5, 0.5, 0.5, -2, 0),
                                    {{-0.5, -0.5, -3}, {0.5, -0.5, -3}, {0.5, 0.5, -3}, {-0.5, 0.5, -1}}});
  const Truth truth = true_visibility(mesh, parallel, Sides::both);
  CHECK(truth.visible_area == std::vector<Rational>{Rational(7, 8), Rational(1, 8)});
  CHECK(truth.uncovered == 3);
}

TEST_CASE("any scale: the same areas from denormals to the largest doubles") {
  const auto scaled = [](double factor) {
    std::vector<Corners> faces{slope_over_x(-1, -1, 1, 1, -2, 0), slope_over_x(-1, 0, 1, 1, -2, 0.5)};
    for (Corners& corners : faces) {
      for (Point3& p : corners) p = factor * p;
    }
    return true_visibility(tests::mesh_of(faces), pinhole, Sides::both).visible_area;
  };
  for (const double factor : {0x1p-1070, 0x1p-500, 0x1p500, 0x1p1020}) CHECK(scaled(factor) == scaled(1));
  // Far and near are in one scene: the far one fills the window, the near one covers a quarter.
  const Mesh both = tests::mesh_of(
      {slope_over_x(-1e150, -1e150, 1e150, 1e150, -1e150, 0), slope_over_x(0, 0, 0x1p-1060, 0x1p-1060, -0x1p-1060, 0)});
  CHECK(true_visibility(both, pinhole, Sides::both).visible_area == std::vector<Rational>{3, 1});
}

TEST_CASE("compare: the area where claims are wrong") {
  const Mesh mesh = tests::mesh_of({slope_over_x(-0.5, -0.5, 0.5, 0.5, -1, 0), slope_over_x(0, 0, 1, 1, -2, 0)});
  const auto square = [](const Rational& low, const Rational& high) { return rectangle(low, low, high, high); };
  const auto clockwise = [](std::vector<RationalPoint> ring) {
    std::reverse(ring.begin(), ring.end());
    return ring;
  };
  const Rational half(1, 2);
  const Rational quarter(1, 4);
  const Claim first{FaceId(0), {square(-half, half)}};
  const Claim second{FaceId(1), {{{half, 0}, {1, 0}, {1, 1}, {0, 1}, {0, half}, {half, half}}}};
  CHECK(wrong(mesh, {first, second}) == 0);
  CHECK(wrong(mesh, {second, first}) == 0);
  CHECK(compare(mesh, parallel, Sides::both, {}).truth.visible_area == std::vector<Rational>{1, Rational(3, 4)});
  CHECK(wrong(mesh, {}) == Rational(7, 4));
  CHECK(wrong(mesh, {first}) == Rational(3, 4));
  // Where two faces are claimed the claim is wrong, even if one of them is right.
  CHECK(wrong(mesh, {first, {FaceId(1), {square(0, 1)}}}) == quarter);
  CHECK(wrong(mesh, {{FaceId(1), first.rings}, {FaceId(0), second.rings}}) == Rational(7, 4));
  // There is a hole, and a claim where nothing is, partly outside the window.
  CHECK(wrong(mesh, {{FaceId(0), {square(-half, half), clockwise(square(-quarter, quarter))}}, second}) == quarter);
  CHECK(wrong(mesh, {first, second, {FaceId(0), {rectangle(-2, -1, Rational(-3, 4), 0)}}}) == quarter);
  // Rings that run clockwise claim nothing; two claims of one face are one.
  CHECK(wrong(mesh, {{FaceId(0), {clockwise(square(-half, half))}}, second}) == 1);
  CHECK(wrong(mesh, {{FaceId(0), {rectangle(-half, -half, 0, half)}},
                     {FaceId(0), {rectangle(0, -half, half, half)}},
                     second}) == 0);
  // The claim is too low by a number that no double holds.
  const Rational third(1, 3);
  CHECK(wrong(mesh, {{FaceId(0), {rectangle(-half, -half - third, half, half - third)}}, second}) == 2 * third);
}

TEST_CASE("compare: a claim of the truth itself is right where faces cross") {
  const Mesh mesh = tests::mesh_of({slope_over_x(-1, -1, 1, 1, -2, 0), slope_over_x(-1, 0, 1, 1, -2, 0.5)});
  const Rational half(1, 2);
  const Claim wall{FaceId(0), {{{-half, -half}, {half, -half}, {half, 0}, {0, 0}, {0, half}, {-half, half}}}};
  const Claim slope{FaceId(1), {{{0, 0}, {Rational(2, 3), 0}, {Rational(2, 3), Rational(2, 3)}, {0, half}}}};
  const auto wrong_part = [&](const std::vector<Claim>& claims) {
    return compare(mesh, pinhole, Sides::both, claims).mislabelled_area;
  };
  CHECK(wrong_part({wall, slope}) == 0);
  // The common line is moved to x = 1/8.
  const Rational x(1, 8);
  const Claim narrow{FaceId(1), {{{x, 0}, {Rational(2, 3), 0}, {Rational(2, 3), Rational(2, 3)}, {x, (2 + x) / 4}}}};
  CHECK(wrong_part({wall, narrow}) == (2 * x + x * x / 2) / 4);
}

}  // namespace sightline::tests::truth_test
