// Smooth mirrors on bodies whose true reflections are known, or whose pose must not matter.
#include "tests/reflect/smooth_bodies.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/reflect/mirror_outcome.h"

namespace sightline::tests::smooth_bodies_test {
namespace {

constexpr std::uint64_t seed = 16;
constexpr double tolerance = 1e-2;
constexpr double field_of_view = 30;

ViewPoint from_beside() {
  ViewPoint view;
  view.eye = {5, 1, 2};
  view.up = {0, 0, 1};
  return view;
}

// A triangle is in one plane however it is turned.
Panel window() { return {"window", {{3, 3, -2}, {2, 3, 4}, {-2, 5, 1}}, Emits::both}; }

struct Reflected {
  double area = 0;
  double uncertain = 0;
};

Reflected reflection(const SmoothBody& body, const std::vector<Panel>& panels, const Camera& camera,
                     double asked = tolerance) {
  const View view = analyzed(mirror_world(AnyMesh(body.mesh()), panels,
                                          {ReflectionMode::smooth, MirrorNormals::vertex, asked}, body.normals()),
                             camera);
  Reflected result;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const double area = image_area(view, p);
    const double uncertain = view.reflections.panels[p].uncertain_area;
    CHECK(uncertain <= std::max(asked * area, 0x1p-28));
    CHECK(view.reflections.panels[p].border_distance <= asked);
    result.area += area;
    result.uncertain += uncertain;
  }
  return result;
}

void check_same(const Reflected& a, const Reflected& b) {
  CHECK(std::fabs(a.area - b.area) <= a.uncertain + b.uncertain);
}

void check_poses(const SmoothBody& body, std::mt19937_64& random, int poses, double& greatest) {
  const Reflected upright = reflection(body, {window()}, moved(from_beside(), field_of_view, {}));
  greatest = std::max(greatest, upright.area);
  for (int i = 0; i < poses; ++i) {
    const Pose pose = random_pose(random);
    check_same(reflection(moved(body, pose), {moved(window(), pose)}, moved(from_beside(), field_of_view, pose)),
               upright);
  }
}

// Parallel rays, which come from a direction; the window is 4 wide.
Camera parallel(const Vector3& from, const Vector3& up) {
  ViewPoint view;
  view.eye = 10 * from;
  view.up = up;
  return orthographic_camera("parallel", view, 4);
}

constexpr double window_area_per_area = 0.25;  // of the parallel cameras

// Returns where a rising function has a value.
template <class Function>
double solved(Function function, double low, double high, double value) {
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (function(middle) < value ? low : high) = middle;
  }
  return low;
}

Panel level_square(double half, double z) {
  return {"square", {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}, Emits::both};
}

// On the unit sphere, seen along its axis, the ray at the distance sin(t) from the axis leaves at 2 t from it. It meets the level z
// at this distance from the axis.
double met_distance(double t, double z) { return std::sin(t) + (z - std::cos(t)) * std::tan(2 * t); }

// Of a square panel, by its outline in polar coordinates, in steps.
double true_sphere_area(double half, double z) {
  constexpr int steps = 4096;
  double area = 0;
  for (int i = 0; i < steps; ++i) {
    const double angle = (i + 0.5) / steps * std::numbers::pi / 4;
    const double t = solved([z](double at) { return met_distance(at, z); }, 0, 0.7, half / std::cos(angle));
    area += std::sin(t) * std::sin(t) / 2 * (std::numbers::pi / 4 / steps);
  }
  return 8 * area * window_area_per_area;
}

// The unit cylinder around z, seen along x: the ray at sin(t) leaves at 2 t from x. It meets the plane y = 3 at this x.
double met_x(double t) { return std::cos(t) + (3 - std::sin(t)) / std::tan(2 * t); }

Panel upright_strip(double left, double right) {
  return {"strip", {{left, 3, -9}, {left, 3, 9}, {right, 3, 9}, {right, 3, -9}}, Emits::both};
}

double true_cylinder_area(double left, double right) {
  const auto falling = [](double t) { return -met_x(t); };
  const double high = solved(falling, 0.1, 1.4, -left);
  const double low = solved(falling, 0.1, 1.4, -right);
  return 2 * (std::sin(high) - std::sin(low)) * window_area_per_area;
}

// What is wrong of the areas is at most twice the tolerance, and what the mesh itself is off by: falling to a fourth where it has
// twice as many sides.
template <class Body>
void check_convergence(Body body, const Panel& panel, const Camera& camera, double truth) {
  double last = 1;
  for (const int n : {16, 32, 64}) {
    CAPTURE(n);
    const Reflected found = reflection(body(n), {panel}, camera, 1e-3);
    const double wrong = std::fabs(found.area - truth) / truth;
    const double of_mesh = 16.0 / (n * n);
    MESSAGE(n << ": off by " << wrong << ", uncertain " << found.uncertain / found.area);
    CHECK(wrong <= 2e-3 + of_mesh);
    CHECK(wrong < last);
    last = wrong;
  }
}

}  // namespace

TEST_CASE("a sphere shows a square as its closed form says, the nearer the finer its mesh") {
  check_convergence(sphere, level_square(1, 3), parallel({0, 0, 1}, {0, 1, 0}), true_sphere_area(1, 3));
}

TEST_CASE("a cylinder shows a strip as its closed form says, the nearer the finer its mesh") {
  check_convergence([](int n) { return cylinder(2 * n); }, upright_strip(-1, 2), parallel({1, 0, 0}, {0, 0, 1}),
                    true_cylinder_area(-1, 2));
}

// Straight behind the body no mirrored ray can be: all turn away from the line of sight.
TEST_CASE("a panel that no mirrored ray can meet is not reflected, at any tolerance") {
  const Panel behind{"behind", {{-4, -1, -1.8}, {-4.2, -0.6, -1.4}, {-4, -0.8, -1.3}}, Emits::both};
  for (const int n : {6, 11, 17, 24, 40}) {
    for (const double asked : {1e-1, 1e-2, 1e-3, 1e-4}) {
      CAPTURE(n);
      CAPTURE(asked);
      CHECK(reflection(sphere(n), {behind}, moved(from_beside(), field_of_view, {}), asked).area == 0);
    }
  }
}

TEST_CASE("a panel in two parts is reflected as the whole is") {
  const Panel whole = window();
  const Point3 middle = (whole.corners[0] + whole.corners[1]) / 2;
  const Panel left{"left", {whole.corners[0], middle, whole.corners[2]}, Emits::both};
  const Panel right{"right", {middle, whole.corners[1], whole.corners[2]}, Emits::both};
  std::mt19937_64 random(seed);
  for (const int sides : {12, 24}) {
    CAPTURE(sides);
    for (int i = 0; i < 4; ++i) {
      const Pose pose = random_pose(random);
      const SmoothBody body = moved(cylinder(sides), pose);
      const Camera camera = moved(from_beside(), field_of_view, pose);
      check_same(reflection(body, {moved(left, pose), moved(right, pose)}, camera),
                 reflection(body, {moved(whole, pose)}, camera));
    }
  }
}

TEST_CASE("the order of faces, and whether a flat one is split, change nothing in a smooth mirror") {
  SmoothBody body = torus(9);
  const Camera camera = moved(from_beside(), field_of_view, {});
  const Reflected first = reflection(body, {window()}, camera);
  SmoothBody turned = body;
  turned.faces = {};
  for (std::size_t f = body.faces.size(); f-- > 0;) turned.faces.push_back(body.faces[f]);
  check_same(reflection(turned, {window()}, camera), first);
  CHECK(first.area > 0);
  // A square with bent normals, and its two halves.
  SmoothBody square{
      {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}}, {{1, -0.2, 0}, {1, 0.4, 0}, {1, 0.4, 0.1}, {1, -0.2, 0.1}}, {}};
  SmoothBody halves = square;
  square.faces.push_back(std::vector{VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  halves.faces.push_back(std::vector{VertexId(0), VertexId(1), VertexId(2)});
  halves.faces.push_back(std::vector{VertexId(0), VertexId(2), VertexId(3)});
  const Panel before{"before", {{6, -3, -3}, {6, 3, -3}, {6, 0, 1}}, Emits::both};
  const Reflected whole = reflection(square, {before}, camera);
  check_same(reflection(halves, {before}, camera), whole);
  CHECK(whole.area > 0);
}

// With a triangle beside it, which no ray meets, a surface is not closed, and the backs of its facets are looked at, too.
TEST_CASE("a closed body reflects what it does where it is not known to be closed") {
  const Camera camera = moved(from_beside(), field_of_view, {});
  for (const int n : {6, 12, 24}) {
    CAPTURE(n);
    const SmoothBody closed = torus(n);
    SmoothBody open = closed;
    const std::size_t first = open.vertices.size();
    for (const Point3& p : {Point3(20, 0, 9), Point3(21, 0, 9), Point3(20, 1, 9)}) {
      open.vertices.push_back(p);
      open.vertex_normals.push_back({0, 0, 1});
    }
    open.faces.push_back(std::vector{VertexId(first), VertexId(first + 1), VertexId(first + 2)});
    const Reflected found = reflection(closed, {window()}, camera, 1e-3);
    check_same(found, reflection(open, {window()}, camera, 1e-3));
    CHECK(found.area > 0);
  }
}

TEST_CASE("smooth bodies reflect the same in every pose") {
  INFO("seed ", seed);
  std::mt19937_64 random(seed);
  double greatest = 0;
  for (const int n : {4, 5, 7, 8, 12, 13, 14, 15, 16, 17, 22, 24, 28, 33, 64}) {
    CAPTURE(n);
    check_poses(sphere(n), random, 20, greatest);
  }
  for (const int sides : {3, 4, 5, 6, 8, 12, 24, 31, 64, 256}) {
    CAPTURE(sides);
    check_poses(cylinder(sides), random, 20, greatest);
  }
  for (const int n : {4, 9, 16, 24}) {
    CAPTURE(n);
    check_poses(torus(n), random, 20, greatest);
  }
  CHECK(greatest > 0.01);
}

}  // namespace sightline::tests::smooth_bodies_test
