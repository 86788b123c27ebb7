// Certified numbers hold what they stand for: chains of sums, differences, products and quotients of numbers at the
// extremes of the exponent range, against rationals.
#include "geometry/numbers/bounded.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace sightline::tests::bounded_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;

constexpr unsigned seed = 20261130;

struct Pair {
  Bounded bounded;
  Exact exact;
};

bool is_known(const Bounded& b) { return std::isfinite(b.value) && std::isfinite(b.radius); }

bool holds(const Pair& p) {
  if (!is_known(p.bounded)) return true;
  return abs(p.exact - Exact(p.bounded.value)) <= Exact(p.bounded.radius);
}

int sign(const Exact& value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

// Short and long mantissas; exponents near each other, or anywhere that a double has.
class Numbers {
 public:
  double operator()() {
    const int digits = random_() % 2 == 0 ? 3 : 53;
    const auto mantissa = static_cast<double>(random_() >> (64 - digits));
    const int exponent = random_() % 4 == 0 ? far_(random_) : near_(random_);
    return std::ldexp(random_() % 2 == 0 ? mantissa : -mantissa, exponent - digits);
  }
  std::size_t choice(std::size_t count) { return random_() % count; }

 private:
  std::mt19937_64 random_{seed};
  std::uniform_int_distribution<int> near_{-4, 4};
  std::uniform_int_distribution<int> far_{-1070, 1000};
};

Pair combined(const Pair& a, const Pair& b, std::size_t operation) {
  switch (operation) {
    case 0:
      return {a.bounded + b.bounded, a.exact + b.exact};
    case 1:
      return {a.bounded - b.bounded, a.exact - b.exact};
    case 2:
      return {a.bounded * b.bounded, a.exact * b.exact};
    default:
      return b.exact == 0 ? a : Pair{a.bounded / b.bounded, a.exact / b.exact};
  }
}

}  // namespace

TEST_CASE("bounded numbers: after every chain of operations the true value is within the radius") {
  INFO("seed ", seed);
  Numbers next;
  std::size_t decided = 0;
  std::size_t undecided = 0;
  std::size_t unknown = 0;
  for (int round = 0; round < 20000; ++round) {
    Pair p{next(), 0};
    p.exact = Exact(p.bounded.value);
    for (int step = 0; step < 6 && is_known(p.bounded); ++step) {
      const double value = next();
      p = combined(p, {value, Exact(value)}, next.choice(4));
      REQUIRE(holds(p));
    }
    if (!is_known(p.bounded)) {
      ++unknown;
      continue;
    }
    const auto certain = certain_sign(p.bounded);
    if (certain) CHECK(*certain == sign(p.exact));
    ++(certain ? decided : undecided);
  }
  // What was to be made hard was: overflows, and signs that nobody can tell.
  CHECK(decided > 1000);
  CHECK(undecided > 100);
  CHECK(unknown > 100);
}

TEST_CASE("bounded numbers: a difference of equal products is undecided, and zero only where it is exactly that") {
  const Bounded a(0.1);
  CHECK(!certain_sign(a * a - a * a));
  CHECK(certain_sign(Bounded(0)) == 0);
  CHECK(!certain_sign(Bounded(0, 1e-300)));
  CHECK(certain_sign(Bounded(1, 0.5)) == 1);
  CHECK(!certain_sign(Bounded(1) / Bounded(0.5, 0.5)));
}

TEST_CASE("bounded numbers: an integer is certain where no rounding can make it another") {
  CHECK(certain_integer(Bounded(0.5), 1) == 1);
  CHECK(certain_integer(Bounded(-0.75), 3) == -6);
  CHECK(certain_integer(Bounded(0.75, 0x1p-40), 3) == 6);
  CHECK(!certain_integer(Bounded(0.25), 1));  // a tie, within its own rounding
  CHECK(!certain_integer(Bounded(0.75, 0.25), 3));
}

TEST_CASE("bounded numbers: what is held around an interval holds its ends") {
  INFO("seed ", seed);
  Numbers next;
  for (int round = 0; round < 1000; ++round) {
    const double a = next();
    const double b = next();
    const Bounded held = bounded_around(std::min(a, b), std::max(a, b));
    CHECK(holds({held, Exact(a)}));
    CHECK(holds({held, Exact(b)}));
  }
}

}  // namespace sightline::tests::bounded_test
