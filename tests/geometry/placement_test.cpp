// Placements are held against rationals: the double that comes out is the nearest one to the true coordinate.
#include "geometry/mesh/placement.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "geometry/mesh/area.h"
#include "geometry/numbers/exact_rounding.h"
#include "tests/tools/polygon_mesh.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::placement_test {
namespace {

using Rational = boost::multiprecision::cpp_rational;

bool has_same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool has_same_bits(const Point3& p, const Point3& q) {
  return has_same_bits(p.x(), q.x()) && has_same_bits(p.y(), q.y()) && has_same_bits(p.z(), q.z());
}

bool is_odd(double x) {
  int unused = 0;
  const double mantissa = std::frexp(x, &unused);
  // The last bit of a denormal is worth more than that of a mantissa of 53 bits.
  const double last = std::max(std::ldexp(1.0, -53), std::ldexp(std::numeric_limits<double>::denorm_min(), -unused));
  return std::fmod(std::fabs(mantissa) / last, 2) == 1;
}

// Whether no neighbour is nearer to the true value, nor as near and even.
bool is_nearest(double x, const Rational& truth) {
  const Rational off = abs(Rational(x) - truth);
  for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
    const double next = std::nextafter(x, towards);
    if (!std::isfinite(next)) continue;
    const Rational next_off = abs(Rational(next) - truth);
    if (next_off < off || (next_off == off && is_odd(x))) return false;
  }
  return true;
}

// The true coordinates, by the header's law.
std::array<Rational, 3> true_place(const Placement& placement, const Point3& p) {
  std::array<Rational, 3> turned{Rational(p.x()), Rational(p.y()), Rational(p.z())};
  if (placement.up_axis == UpAxis::z) turned = {Rational(p.x()), Rational(p.z()), -Rational(p.y())};
  if (placement.up_axis == UpAxis::x) turned = {-Rational(p.y()), Rational(p.x()), Rational(p.z())};
  const Rational length = Rational(placement.length.numerator) / Rational(placement.length.denominator);
  std::array<Rational, 3> result;
  for (int i = 0; i < 3; ++i) {
    Rational sum = 0;
    for (int j = 0; j < 3; ++j) sum += Rational(placement.matrix(i, j)) * turned[static_cast<std::size_t>(j)];
    result[static_cast<std::size_t>(i)] = sum * length + Rational(placement.matrix(i, 3));
  }
  return result;
}

void check_nearest(const Placement& placement, const Point3& p) {
  const Point3 found = placed(placement, p);
  const auto truth = true_place(placement, p);
  for (int i = 0; i < 3; ++i) CHECK(is_nearest(found(i), truth[static_cast<std::size_t>(i)]));
}

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : random_(seed) {}

  double number(int exponents) {
    const double mantissa = std::uniform_real_distribution<double>(-1, 1)(random_);
    return std::ldexp(mantissa, std::uniform_int_distribution<int>(-exponents, exponents)(random_));
  }
  double small_integer() { return std::uniform_int_distribution<int>(-9, 9)(random_); }

 private:
  std::mt19937_64 random_;
};

Placement random_placement(RandomNumbers& random, int exponents) {
  constexpr std::array lengths{LengthRatio{1, 1}, LengthRatio{1, 1000}, LengthRatio{127, 5000}, LengthRatio{0.1, 1}};
  Placement placement;
  for (int i = 0; i < 12; ++i) placement.matrix(i / 4, i % 4) = random.number(exponents);
  placement.length = lengths[static_cast<std::size_t>(std::fabs(random.small_integer())) % lengths.size()];
  placement.up_axis =
      std::array{UpAxis::x, UpAxis::y, UpAxis::z}[static_cast<std::size_t>(std::fabs(random.small_integer())) % 3];
  return placement;
}

Placement with_rows(const std::array<std::array<double, 4>, 3>& rows) {
  Placement placement;
  for (int i = 0; i < 12; ++i)
    placement.matrix(i / 4, i % 4) = rows[static_cast<std::size_t>(i / 4)][static_cast<std::size_t>(i % 4)];
  return placement;
}

const Placement mirror_image = with_rows({{{-1, 0, 0, 7}, {0, 1, 0, 0}, {0, 0, 1, 0}}});

Vector3 normal_of(const Corners& c) { return (c[1] - c[0]).cross(c[2] - c[0]); }

}  // namespace

TEST_CASE("each coordinate is the double nearest to the true one") {
  constexpr std::uint64_t seed = 20261130;
  INFO("seed " << seed);
  RandomNumbers random(seed);
  for (int i = 0; i < 300; ++i) {
    const int exponents = std::array{1, 30, 300}[static_cast<std::size_t>(i % 3)];
    const Placement placement = random_placement(random, exponents);
    check_nearest(placement, {random.number(exponents), random.number(exponents), random.number(exponents)});
  }
}

TEST_CASE("the same where terms cancel, where halves are ties, and in the denormal range") {
  RandomNumbers random(7);
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  for (int i = 0; i < 160; ++i) {
    Placement placement;
    for (int j = 0; j < 12; ++j) placement.matrix(j / 4, j % 4) = random.small_integer();
    placement.length = {1, std::array{1.0, 2.0, 8.0, 3.0}[static_cast<std::size_t>(i % 4)]};
    const double unit = std::array{1.0, tiny, 1 + 0x1p-52, 0x1p53 - 1}[static_cast<std::size_t>(i / 4 % 4)];
    check_nearest(placement,
                  {unit * random.small_integer(), unit * random.small_integer(), unit * random.small_integer()});
  }
}

TEST_CASE("a ratio is rounded to nearest even, once, also where it is denormal") {
  CHECK(rounded_ratio(1, 3, 0) == 1.0 / 3);
  CHECK(rounded_ratio(-1, 3, 0) == -1.0 / 3);
  CHECK(rounded_ratio((BigInteger(1) << 53) + 1, 1, 0) == 0x1p53);
  CHECK(rounded_ratio((BigInteger(1) << 53) + 3, 1, 0) == 0x1p53 + 4);
  CHECK(rounded_ratio(1, 1, -1075) == 0);
  CHECK(rounded_ratio(3, 1, -1075) == 0x1p-1073);
  CHECK(rounded_ratio((BigInteger(1) << 60) + 1, BigInteger(1) << 60, -1075) == 0x1p-1074);
  CHECK(rounded_ratio(1, BigInteger(1) << 3000, 0) == 0);
  CHECK(rounded_ratio(1, 1, 1024) == HUGE_VAL);
  CHECK(rounded_ratio(BigInteger(1) << 3000, BigInteger(1) << 2999, 0) == 2);
}

TEST_CASE("what changes nothing, and what only turns axes, leaves bits alone") {
  const Point3 p{-0.0, 0.1, -5e-324};
  CHECK(Placement{}.changes_nothing());
  CHECK(has_same_bits(placed(Placement{}, p), p));
  CHECK(has_same_bits(placed({.up_axis = UpAxis::z}, p), Point3(-0.0, -5e-324, -0.1)));
  CHECK(has_same_bits(placed({.up_axis = UpAxis::x}, p), Point3(-0.1, -0.0, -5e-324)));
}

TEST_CASE("units are exact: 1500 mm are 1.5 m, and 3 feet a yard") {
  CHECK(placed({.length = {1, 1000}}, {1500, 1, 3}) == Point3(1.5, 0.001, 0.003));
  CHECK(placed({.length = {381, 1250}}, {3, 1, 0}) == Point3(0.9144, 0.3048, 0));
  CHECK(placed({.length = {127, 5000}}, {1, 100, 0}) == Point3(0.0254, 2.54, 0));
}

TEST_CASE("turning the upwards axis keeps right and left") {
  for (const UpAxis up : {UpAxis::x, UpAxis::y, UpAxis::z}) {
    const Placement placement{.up_axis = up};
    const Vector3 x = placed(placement, {1, 0, 0});
    const Vector3 y = placed(placement, {0, 1, 0});
    const Vector3 z = placed(placement, {0, 0, 1});
    CHECK(x.cross(y) == z);
    CHECK((up == UpAxis::x ? x : (up == UpAxis::y ? y : z)) == Vector3(0, 1, 0));
  }
}

TEST_CASE("a mirror image has its faces' fronts, and its normals, where they were") {
  Mesh mesh = mesh_of({{{0, 0, 0}, {2, 0, 0}, {0, 1, 1}}, {{0, 0, 3}, {1, 0, 3}, {1, 1, 3}, {0, 1, 3}}});
  std::vector<Vector3> normals;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const VertexId v : mesh.faces[f]) {
      Vector3 normal = f == 0 ? Vector3(0, -1, 1) : Vector3(0, 0, 1);
      normal.x() = 0.125 * static_cast<double>(v.index());
      normals.push_back(normal);
    }
  }
  const std::vector<Vector3> before = normals;
  PolygonList faces = mesh.faces;
  std::vector<Point3> vertices = mesh.vertices;
  CHECK(mirror_image.orientation() < 0);
  place(mirror_image, vertices, faces, normals);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Corners corners;
    for (const VertexId v : faces[f]) corners.push_back(vertices[v.index()]);
    Corners old;
    for (const VertexId v : mesh.faces[f]) old.push_back(mesh.vertices[v.index()]);
    Vector3 expected = normal_of(old);
    expected.x() = -expected.x();
    CHECK(normal_of(corners) == expected);
    for (std::size_t i = faces.begin[f]; i < faces.begin[f + 1]; ++i) {
      const Vector3& given = before[faces.corners[i].index()];
      CHECK(unit(normals[i]).isApprox(unit(Vector3(-given.x(), given.y(), given.z())), 1e-15));
    }
  }
}

TEST_CASE("normals stay across the surface when it is sheared and stretched") {
  RandomNumbers random(11);
  for (int i = 0; i < 200; ++i) {
    Placement placement = random_placement(random, 2);
    const Corners corners{{random.number(1), random.number(1), random.number(1)},
                          {random.number(1), random.number(1), random.number(1)},
                          {random.number(1), random.number(1), random.number(1)}};
    Mesh mesh = mesh_of({corners});
    std::vector<Vector3> normals(3, normal_of(corners));
    place(placement, mesh.vertices, mesh.faces, normals);
    Corners moved;
    for (const VertexId v : mesh.faces[0]) moved.push_back(mesh.vertices[v.index()]);
    CHECK(unit(normals[0]).isApprox(unit(normal_of(moved)), 1e-6));
  }
}

TEST_CASE("what flattens the mesh, exactly, and what leaves the range of double is refused") {
  const Placement flat = with_rows({{{0.1, 0.2, 0.3, 0}, {0.2, 0.4, 0.6, 1}, {0, 0, 1, 0}}});
  CHECK(flat.orientation() == 0);
  std::vector<Point3> vertices{{1, 2, 3}};
  PolygonList faces;
  std::vector<Vector3> normals;
  CHECK(says_what_to_do(message_of<PlacementError>([&] { place(flat, vertices, faces, normals); })));
  const Placement nearly = with_rows({{{0.1, 0.3, 0, 0}, {0.3, 0.9, 0, 1}, {0, 0, 1, 0}}});
  CHECK(nearly.orientation() != 0);  // 3 * 0.1 is not the double 0.3
  const auto out_of_range = [] { static_cast<void>(placed({.length = {1e300, 1}}, {1e300, 0, 0})); };
  CHECK(says_what_to_do(message_of<PlacementError>(out_of_range)));
}

}  // namespace sightline::tests::placement_test
