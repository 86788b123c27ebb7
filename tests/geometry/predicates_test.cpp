// Each tier of the predicates is held against the next, and the exact tier against rationals.
#include "geometry/numbers/predicates.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace sightline::tests::predicates_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;

struct Exact3 {
  Exact x, y, z;
};

Exact3 difference(const Point3& a, const Point3& b) {
  return {Exact(a.x()) - Exact(b.x()), Exact(a.y()) - Exact(b.y()), Exact(a.z()) - Exact(b.z())};
}

int sign(const Exact& value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

int rational_orient3d(const Point3& a, const Point3& b, const Point3& c, const HomogeneousPoint& d) {
  const Exact3 u = difference(b, a);
  const Exact3 v = difference(c, a);
  const Exact3 w = d.w == 0 ? difference(d.xyz, {0, 0, 0}) : difference(d.xyz, a);
  return sign(u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x));
}

int rational_orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return sign((Exact(b.x) - Exact(a.x)) * (Exact(c.y) - Exact(a.y)) -
              (Exact(b.y) - Exact(a.y)) * (Exact(c.x) - Exact(a.x)));
}

int rational_in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  Exact determinant = 0;
  const std::array points{a, b, c};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto from_d = [&](std::size_t k) {
      return std::array{Exact(points[k % 3].x) - Exact(d.x), Exact(points[k % 3].y) - Exact(d.y)};
    };
    const auto p = from_d(i);
    const auto q = from_d(i + 1);
    const auto r = from_d(i + 2);
    determinant += (p[0] * p[0] + p[1] * p[1]) * (q[0] * r[1] - q[1] * r[0]);
  }
  return sign(determinant);
}

// These coordinates make predicates hard: they are on a small grid, a last bit away from it, far off, and of any size.
class HardCoordinates {
 public:
  explicit HardCoordinates(unsigned seed) : random_(seed) {}

  void next_kind() { kind_ = std::uniform_int_distribution(0, 4)(random_); }

  double operator()() {
    const double grid = std::uniform_int_distribution(-3, 3)(random_);
    switch (kind_) {
      case 0:
        return grid;
      case 1:
        return std::nextafter(grid, std::uniform_int_distribution(0, 1)(random_) == 0 ? -10.0 : 10.0);
      case 2:
        return 1e8 + 0x1p-20 * grid;
      case 3:
        return std::ldexp(grid, std::uniform_int_distribution(-1074, 1000)(random_));
      default:
        return std::ldexp(grid, -520);
    }
  }

  Point3 point3() { return {(*this)(), (*this)(), (*this)()}; }
  Point2 point2() { return {(*this)(), (*this)()}; }

 private:
  std::mt19937 random_;
  int kind_ = 0;
};

// These count how often each outcome was met.
struct Outcomes {
  int undecided = 0;
  int zero = 0;
  int nonzero = 0;

  void check(std::optional<Sign> filtered, Sign exact, int rational) {
    CHECK(exact == rational);
    if (filtered) CHECK(*filtered == rational);
    undecided += filtered ? 0 : 1;
    zero += rational == 0 ? 1 : 0;
    nonzero += rational != 0 ? 1 : 0;
  }

  void check_all_met() const {
    CHECK(undecided > 100);
    CHECK(zero > 100);
    CHECK(nonzero > 100);
  }
};

constexpr unsigned seed = 20261122;
constexpr int rounds = 4000;

}  // namespace

TEST_CASE("orient3d: filter, integers and rationals agree") {
  INFO("seed ", seed);
  HardCoordinates next(seed);
  Outcomes outcomes;
  for (int i = 0; i < rounds; ++i) {
    next.next_kind();
    const Point3 a = next.point3();
    const Point3 b = next.point3();
    const Point3 c = next.point3();
    const HomogeneousPoint d{next.point3(), i % 3 == 0 ? 0 : 1};
    CAPTURE(i);
    outcomes.check(predicates::filter::orient3d(a, b, c, d), predicates::exact::orient3d(a, b, c, d),
                   rational_orient3d(a, b, c, d));
    CHECK(orient3d(a, b, c, d) == -orient3d(b, a, c, d));
    if (d.w == 1) CHECK(orient3d(a, b, c, d.xyz) == -orient3d(a, b, d.xyz, c));
  }
  outcomes.check_all_met();
}

TEST_CASE("orient2d: filter, integers and rationals agree") {
  INFO("seed ", seed);
  HardCoordinates next(seed);
  Outcomes outcomes;
  for (int i = 0; i < rounds; ++i) {
    next.next_kind();
    const Point2 a = next.point2();
    const Point2 b = next.point2();
    const Point2 c = next.point2();
    CAPTURE(i);
    outcomes.check(predicates::filter::orient2d(a, b, c), predicates::exact::orient2d(a, b, c),
                   rational_orient2d(a, b, c));
    CHECK(orient2d(a, b, c) == -orient2d(b, a, c));
    CHECK(orient2d(a, b, c) == orient2d(b, c, a));
  }
  outcomes.check_all_met();
}

TEST_CASE("in_circle: filter, integers and rationals agree") {
  INFO("seed ", seed);
  HardCoordinates next(seed);
  Outcomes outcomes;
  for (int i = 0; i < rounds; ++i) {
    next.next_kind();
    const Point2 a = next.point2();
    const Point2 b = next.point2();
    const Point2 c = next.point2();
    const Point2 d = next.point2();
    CAPTURE(i);
    outcomes.check(predicates::filter::in_circle(a, b, c, d), predicates::exact::in_circle(a, b, c, d),
                   rational_in_circle(a, b, c, d));
    CHECK(in_circle(a, b, c, d) == -in_circle(b, a, c, d));
  }
  outcomes.check_all_met();
}

TEST_CASE("in_circle: a filter that answers is right where squares underflow beside large minors") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> grid(-4, 4);
  int answered = 0;
  for (int i = 0; i < rounds; ++i) {
    const double tiny = std::ldexp(1.0, -540 + i % 20);
    const double large = std::ldexp(1.0, 170 + i % 90);
    const auto at = [&](double unit) { return Point2{unit * grid(random), unit * grid(random)}; };
    const Point2 a = at(tiny);
    const Point2 b = at(large);
    const Point2 c = at(large);
    const Point2 d = at(i % 2 == 0 ? tiny : large);
    CAPTURE(i);
    const auto filtered = predicates::filter::in_circle(a, b, c, d);
    answered += filtered ? 1 : 0;
    CHECK(filtered.value_or(rational_in_circle(a, b, c, d)) == rational_in_circle(a, b, c, d));
    CHECK(predicates::exact::in_circle(a, b, c, d) == rational_in_circle(a, b, c, d));
  }
  CHECK(answered > 100);
  CHECK(answered < rounds);
}

TEST_CASE("orient3d: products that underflow beside a huge difference") {
  // The determinant is 2^1000 2^-537 2^-538 - 2^58 2^400 2^-538 = 2^-75 - 2^-80, and the first product of two
  // underflows.
  const Point3 origin{0, 0, 0};
  const Point3 b{std::ldexp(1.0, 1000), std::ldexp(1.0, 58), 0};
  const Point3 c{std::ldexp(1.0, 400), std::ldexp(1.0, -537), 0};
  const Point3 d{0, 0, std::ldexp(1.0, -538)};
  CHECK(predicates::filter::orient3d(origin, b, c, {d, 1}).value_or(1) == 1);
  CHECK(orient3d(origin, b, c, d) == 1);
}

// Plain evaluation calls a hundredth of these wrong (Kettner et al., Classroom examples of robustness problems, 2008).
TEST_CASE("orient2d: points in a last bit's distance of the line through two far points") {
  int wrong_without_bound = 0;
  for (int i = 0; i < 256; i += 2) {
    for (int j = 0; j < 256; ++j) {
      const Point2 p{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
      const double difference = (12 - p.x) * (24 - p.y) - (12 - p.y) * (24 - p.x);
      const Sign expected = sign_of(p.y - p.x);
      wrong_without_bound += difference != 0 && sign_of(difference) != expected ? 1 : 0;
      CHECK(orient2d(p, {12, 12}, {24, 24}) == expected);
    }
  }
  CHECK(wrong_without_bound > 100);
}

TEST_CASE("a dyadic number is its double, with an odd mantissa") {
  for (const double value : {1.0, -3.0, 0.1, 0x1p-1074, -0x1.fffffffffffffp1023, 0x1p52, 12.0}) {
    const Dyadic d = dyadic(value);
    CHECK(std::ldexp(static_cast<double>(d.mantissa), d.exponent) == value);
    CHECK(d.mantissa % 2 != 0);
  }
  CHECK(dyadic(0.0).mantissa == 0);
  CHECK(dyadic(-0.0).mantissa == 0);
}

TEST_CASE("a quotient is rounded once, as the division of doubles rounds it") {
  std::mt19937_64 random(seed);
  for (int i = 0; i < 2000; ++i) {
    const auto numerator = static_cast<double>(static_cast<std::int64_t>(random()) >> 11);
    const auto denominator = static_cast<double>((random() >> (12 + i % 40)) + 1);
    CAPTURE(numerator);
    CAPTURE(denominator);
    CHECK(rounded_quotient(BigInteger(numerator), BigInteger(denominator)) == numerator / denominator);
    CHECK(rounded_quotient(Wide512(numerator), Wide512(denominator)) == numerator / denominator);
    const BigInteger scale = BigInteger(1) << 150;
    CHECK(rounded_quotient(BigInteger(BigInteger(numerator) * scale), BigInteger(denominator)) ==
          std::ldexp(numerator / denominator, 150));
  }
  // The quotient is halfway between two doubles, and then one part in 2^200 beyond.
  const BigInteger half = (BigInteger(1) << 53) + 1;
  CHECK(rounded_quotient(half, BigInteger(1)) == 0x1p53);
  CHECK(rounded_quotient(BigInteger((half << 200) + 1), BigInteger(BigInteger(1) << 200)) == 0x1p53 + 2);
}

TEST_CASE("three points on a line are collinear in any direction, and a last bit off they are not") {
  CHECK(collinear(Point3{0, 0, 0}, {1, 2, 3}, {2, 4, 6}));
  CHECK(collinear(Point3{0, 0, 0}, {0, 0, 0}, {2, 4, 6}));
  CHECK_FALSE(collinear(Point3{0, 0, 0}, {1, 2, 3}, {2, 4, std::nextafter(6.0, 7.0)}));
  CHECK_FALSE(collinear(Point3{0, 0, 0}, {0x1p-1074, 0, 0}, {0, 0x1p-1074, 0}));
}

}  // namespace sightline::tests::predicates_test
