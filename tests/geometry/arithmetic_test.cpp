// The dial: exact by default; float and double decide plainly, may be wrong, and end on every input.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "geometry/projection/unfiltered.h"
#include "oracle/judging/judge.h"
#include "oracle/scenes/random_scenes.h"
#include "sweep/segments/image_decisions.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::arithmetic_test {
namespace {

constexpr unsigned seed = 20240;
constexpr std::array inexact{Arithmetic::single_precision, Arithmetic::double_precision};

// These count how runs ended.
struct Outcomes {
  int complete = 0;
  int too_weak = 0;
};

// Anything but a view or an ArithmeticError fails the test.
void run(const Mesh& mesh, const Camera& camera, Sides sides, const Precision& precision, Outcomes& outcomes) {
  try {
    const View view = analyzed(mesh, camera, sides, precision);
    CHECK(validate(view.segments, view.scene).empty());
    ++outcomes.complete;
  } catch (const ArithmeticError& error) {
    CHECK(!error.broken().empty());
    ++outcomes.too_weak;
  }
}

double magnitude(std::mt19937& random, int exponents) {
  return std::ldexp(1.0, std::uniform_int_distribution<int>(-exponents, exponents)(random));
}

// Vertices are around the origin, of any size, and now and then a hair from another one.
std::vector<Point3> extreme_vertices(std::mt19937& random, std::size_t count, int exponents) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Point3> vertices;
  const double size = magnitude(random, exponents);
  while (vertices.size() < count) {
    Point3 p{size * unit(random), size * unit(random), size * unit(random)};
    if (vertices.size() > 3 && random() % 3 == 0) {
      const Point3& other = vertices[random() % vertices.size()];
      const double near = std::ldexp(1.0, -20 - static_cast<int>(random() % 36));
      p = {other.x() + near * p.x(), other.y() + near * p.y(), other.z()};
    }
    if (random() % 5 == 0) p.z() = 0;
    vertices.push_back(p);
  }
  return vertices;
}

Mesh extreme_mesh(std::mt19937& random, int exponents) {
  const std::size_t count = 12;
  PolygonList faces;
  for (std::size_t f = 0; f < 16; ++f) {
    faces.push_back(std::array{VertexId(random() % count), VertexId(random() % count), VertexId(random() % count)});
  }
  return build_mesh(extreme_vertices(random, count, exponents), std::move(faces));
}

Camera looking_at(const Mesh& mesh, double distance) {
  double size = 0;
  for (const Point3& v : mesh.vertices) size = std::max({size, std::fabs(v.x()), std::fabs(v.y()), std::fabs(v.z())});
  const Point3 eye{distance * size, distance * size / 3, distance * size};
  return perspective_camera("extreme", {eye, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 40);
}

// Two squares cover each other seen from far up z; the nearer one is the second, by `gap`.
Mesh two_sheets(double gap) {
  std::vector<Point3> vertices;
  PolygonList faces;
  for (const double z : {1.0, 1.0 + gap}) {
    const std::size_t first = vertices.size();
    vertices.insert(vertices.end(), {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
    faces.push_back(std::array{VertexId(first), VertexId(first + 1), VertexId(first + 2), VertexId(first + 3)});
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

Camera from_above() { return orthographic_camera("above", {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 4); }

std::size_t visible_face(const Mesh& mesh, Arithmetic arithmetic) {
  const View view = analyzed(mesh, from_above(), Sides::both, {arithmetic});
  REQUIRE(view.polygons.polygons.size() == 1);
  return view.polygons.polygons[0].face.index();
}

}  // namespace

TEST_CASE("arithmetics have names, and exact is the default") {
  for (const Arithmetic a : {Arithmetic::single_precision, Arithmetic::double_precision, Arithmetic::exact}) {
    CHECK(arithmetic_named(to_string(a)) == a);
  }
  CHECK_FALSE(arithmetic_named("quad"));
  CHECK(Precision{}.arithmetic == Arithmetic::exact);
  CHECK(project(two_sheets(1), from_above(), Sides::both).arithmetic == Arithmetic::exact);
}

TEST_CASE("which of two sheets is in front: float, then double lose it as the gap shrinks, exact never does") {
  CHECK(visible_face(two_sheets(0x1p-10), Arithmetic::single_precision) == 1);
  CHECK(visible_face(two_sheets(0x1p-30), Arithmetic::single_precision) == 0);
  CHECK(visible_face(two_sheets(0x1p-30), Arithmetic::double_precision) == 1);
  CHECK(visible_face(two_sheets(0x1p-52), Arithmetic::exact) == 1);
}

TEST_CASE("double loses a side that exact sees: a corner on the plane but for the last bits") {
  const Point3 a{12, 12, 0};
  const Point3 b{24, 24, 0};
  const Point3 c{12, 12, 1};
  const HomogeneousPoint d{{0.5, std::nextafter(0.5, 1), 0}, 1};
  CHECK(orient3d(a, b, c, d) != 0);
  CHECK(unfiltered::orient3d(Arithmetic::double_precision, a, b, c, d) == 0);
}

TEST_CASE("plain evaluation of what over- or underflows is a sign, and a place in the window") {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const Arithmetic arithmetic : inexact) {
    for (const double s : {huge, tiny, 1.0}) {
      const HomogeneousPoint d{{s, s, -s}, 1};
      const Sign sign = unfiltered::orient3d(arithmetic, {-s, 0, s}, {s, 0, 0}, {0, -s, s}, d);
      CHECK(std::abs(sign) <= 1);
      if (s != 1.0) CHECK(sign == 0);
    }
  }
  const Camera camera = from_above();
  const ImagePoint beyond = unfiltered::image_point({Arithmetic::double_precision, 8}, {5, -huge, 0}, camera);
  CHECK(beyond == ImagePoint{256, -256});
  const Precision precision{Arithmetic::single_precision, 8};
  CHECK_THROWS_AS(
      static_cast<void>(unfiltered::image_point(precision, {huge, -huge, huge}, looking_at(two_sheets(1), 2))),
      ArithmeticError);
}

TEST_CASE("directions are in one order in any arithmetic, horizontal ones last") {
  using Decisions = UnfilteredDecisions<float>;
  const auto towards = [](std::int64_t x, std::int64_t y) { return Decisions::direction({0, 0}, {x, y}); };
  const std::vector<float> left_to_right{towards(-9, -1), towards(-1, -1), towards(0, -1),
                                         towards(1, -1),  towards(9, -1),  towards(1, 0)};
  for (std::size_t i = 0; i < left_to_right.size(); ++i) {
    for (std::size_t j = 0; j < left_to_right.size(); ++j) {
      CHECK(Decisions::turn(left_to_right[i], left_to_right[j]) == (i < j ? 1 : (i > j ? -1 : 0)));
    }
  }
}

TEST_CASE("on a coarse grid exact stays valid, and double agrees where everything is on the grid") {
  for (std::uint64_t s = 1; s <= lattice::scene_count(200); ++s) {
    CAPTURE(s);
    const lattice::RandomScene scene = lattice::random_scene(s);
    const Mesh mesh = lattice::mesh_of(scene);
    for (const int bits : {8, 13, 24}) {
      const View view = analyzed(mesh, scene.camera, scene.sides, {Arithmetic::exact, bits});
      CHECK(validate(view.scene).empty());
      CHECK(validate(view.segments, view.scene).empty());
      CHECK(validate(view.polygons, view.scene, view.segments).empty());
    }
  }
}

TEST_CASE("float and double end on random scenes full of coincidences") {
  for (const Arithmetic arithmetic : inexact) {
    Outcomes outcomes;
    for (std::uint64_t s = 1; s <= lattice::scene_count(2000); ++s) {
      CAPTURE(s);
      const lattice::RandomScene scene = lattice::random_scene(s);
      run(lattice::mesh_of(scene), scene.camera, scene.sides, {arithmetic}, outcomes);
    }
    MESSAGE(to_string(arithmetic) << ": " << outcomes.complete << " complete, " << outcomes.too_weak << " too weak");
    CHECK(outcomes.complete > 0);
    CHECK(outcomes.too_weak > 0);
  }
}

TEST_CASE("float and double end on extreme scenes, on any grid") {
  INFO("seed ", seed);
  for (const Arithmetic arithmetic : inexact) {
    std::mt19937 random(seed);
    Outcomes outcomes;
    for (std::uint64_t i = 0; i < lattice::scene_count(1500); ++i) {
      CAPTURE(i);
      const Mesh mesh = extreme_mesh(random, i % 3 == 0 ? 300 : 10);
      const Camera camera = looking_at(mesh, i % 2 == 0 ? 0.3 : 4);
      const int bits = static_cast<int>(8 + random() % 33);
      run(mesh, camera, Sides::both, {arithmetic, bits}, outcomes);
    }
    MESSAGE(to_string(arithmetic) << ": " << outcomes.complete << " complete, " << outcomes.too_weak << " too weak");
    CHECK(outcomes.complete > 0);
    CHECK(outcomes.too_weak > 0);
  }
}

}  // namespace sightline::tests::arithmetic_test
