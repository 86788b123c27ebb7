// Double words hold what they stand for: chains of operations against rationals; and what they round is rounded right.
#include "geometry/numbers/double_word.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace sightline::tests::double_word_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;

constexpr unsigned seed = 20261130;

struct Pair {
  DoubleWord word;
  Exact exact;
};

bool is_known(const DoubleWord& a) { return std::isfinite(a.high) && std::isfinite(a.low) && std::isfinite(a.radius); }

bool holds(const Pair& p) { return abs(p.exact - (Exact(p.word.high) + Exact(p.word.low))) <= Exact(p.word.radius); }

double nearest(const Exact& value) {
  return rounded_quotient(BigInteger(numerator(value)), BigInteger(denominator(value)));
}

// Short and long mantissas; exponents near each other, or anywhere that a double has.
class Numbers {
 public:
  double operator()() {
    const int digits = random_() % 2 == 0 ? 3 : 53;
    const auto mantissa = static_cast<double>(random_() >> (64 - digits));
    const int exponent = random_() % 8 == 0 ? far_(random_) : near_(random_);
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
      return {a.word + b.word, a.exact + b.exact};
    case 1:
      return {a.word - b.word, a.exact - b.exact};
    case 2:
      return {a.word * b.word, a.exact * b.exact};
    default:
      return b.exact == 0 ? a : Pair{a.word / b.word, a.exact / b.exact};
  }
}

Pair known(double value) { return {value, Exact(value)}; }

}  // namespace

TEST_CASE("double words: after every chain of operations the true value is within the radius, and rounds as they say") {
  INFO("seed ", seed);
  Numbers next;
  std::size_t rounded = 0;
  std::size_t open = 0;
  std::size_t unknown = 0;
  for (int round = 0; round < 20000; ++round) {
    Pair p = known(next());
    for (int step = 0; step < 6 && is_known(p.word); ++step) {
      // A word of two doubles, too, so that low parts meet low parts.
      const Pair other = next.choice(2) == 0 ? known(next()) : combined(known(next()), known(next()), next.choice(4));
      if (!is_known(other.word)) continue;
      p = combined(p, other, next.choice(4));
      if (is_known(p.word)) REQUIRE(holds(p));
    }
    if (!is_known(p.word)) {
      ++unknown;
      continue;
    }
    const auto certain = certain_rounding(p.word);
    if (certain) CHECK(*certain == nearest(p.exact));
    ++(certain ? rounded : open);
  }
  // What was to be made hard was: overflows, and roundings that nobody can tell.
  CHECK(rounded > 10000);
  CHECK(open > 100);
  CHECK(unknown > 100);
}

TEST_CASE("double words: what is half-way between two doubles is rounded by nobody") {
  CHECK(!certain_rounding(DoubleWord(1) + DoubleWord(0x1p-53)));
  CHECK(!certain_rounding(DoubleWord(1) - DoubleWord(0x1p-54)));
  CHECK(certain_rounding(DoubleWord(1) + DoubleWord(0x1p-55)) == 1);
  CHECK(certain_rounding(DoubleWord(1) - DoubleWord(0x1p-55)) == 1);
  CHECK(certain_rounding(DoubleWord(1) / DoubleWord(3)) == 1.0 / 3);
  CHECK(!certain_rounding(DoubleWord(1) - DoubleWord(1)));
}

TEST_CASE("double words: a vector product is known to a hundred bits") {
  const DoubleWordVector product = cross(in_words({1, 1e-10, 3}), in_words({1, 1e-10, 3.0000000000001}));
  const Exact expected = Exact(1e-10) * Exact(3.0000000000001) - Exact(3.0) * Exact(1e-10);
  CHECK(holds({product.x(), expected}));
  CHECK(product.x().radius < 1e-36);
  CHECK(holds({dot(product, in_words({1, 1e-10, 3})), Exact(0)}));
}

}  // namespace sightline::tests::double_word_test
