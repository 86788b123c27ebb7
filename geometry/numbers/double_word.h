// Certified numbers of twice the length of a double, by which a result can be proved to round to one double.
//
// A double word is the sum of two doubles, the second at most half a unit in the last place of the first; as with Bounded,
// |true value - value| <= radius, for sums, differences, products and quotients, and where nothing is known (an overflow) the
// radius is infinite or no number, and nothing is certain.
//
// Derivation, with u = 2^-53. Joldes, Muller and Popescu 2017 prove for their algorithms 6 (sum), 11 (product) and 17 (quotient)
// relative errors of at most 3 u^2 + 13 u^3, 5 u^2 and 15 u^2 + 56 u^3: all below 2^-102 = 16 u^2. A product that underflows is
// off by less than 2^-1060 beside. What the operands' radii let through is as in bounded.h; the magnitude of a double word is
// taken as |high| + |low|, which is not less than it is but by a rounding, and `widened` has room for one more.
// Source: M. Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic, ACM TOMS 44 (2017).
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "geometry/numbers/bounded.h"

namespace sightline::inline geometry {

struct DoubleWord {
  double high = 0;
  double low = 0;
  double radius = 0;

  constexpr DoubleWord() = default;
  // Exactly this number.
  constexpr DoubleWord(double exact) : high(exact) {}

  [[nodiscard]] double magnitude() const { return std::abs(high) + std::abs(low); }
  // Proven.
  [[nodiscard]] bool is_not_zero() const { return std::abs(high) - std::abs(low) > Bounded::widened(radius); }
};

namespace double_word {

constexpr double roundoff = 0x1p-102;
static_assert(roundoff > 15 * unit_roundoff * unit_roundoff + 56 * unit_roundoff * unit_roundoff * unit_roundoff);
constexpr double underflow = 0x1p-1060;

// Returns a + b exactly.
inline DoubleWord sum(double a, double b) {
  DoubleWord s;
  s.high = a + b;
  const double b_taken = s.high - a;
  s.low = (a - (s.high - b_taken)) + (b - b_taken);
  return s;
}

// The same where |a| >= |b|, or a is zero.
inline DoubleWord ordered_sum(double a, double b) {
  DoubleWord s;
  s.high = a + b;
  s.low = b - (s.high - a);
  return s;
}

// Returns a b, exactly but for an underflow.
inline DoubleWord product(double a, double b) {
  DoubleWord p;
  p.high = a * b;
  p.low = std::fma(a, b, -p.high);
  return p;
}

// Algorithm 7, as the quotient wants it.
inline DoubleWord product(const DoubleWord& a, double b) {
  const DoubleWord high = product(a.high, b);
  const DoubleWord once = ordered_sum(high.high, a.low * b);
  return ordered_sum(once.high, once.low + high.low);
}

}  // namespace double_word

inline DoubleWord operator-(const DoubleWord& a) {
  DoubleWord negative = a;
  negative.high = -a.high;
  negative.low = -a.low;
  return negative;
}

inline DoubleWord operator+(const DoubleWord& a, const DoubleWord& b) {
  const DoubleWord high = double_word::sum(a.high, b.high);
  const DoubleWord low = double_word::sum(a.low, b.low);
  const DoubleWord once = double_word::ordered_sum(high.high, high.low + low.high);
  DoubleWord result = double_word::ordered_sum(once.high, low.low + once.low);
  result.radius = Bounded::widened(a.radius + b.radius + double_word::roundoff * result.magnitude());
  return result;
}

inline DoubleWord operator-(const DoubleWord& a, const DoubleWord& b) { return a + -b; }

inline DoubleWord operator*(const DoubleWord& a, const DoubleWord& b) {
  const DoubleWord high = double_word::product(a.high, b.high);
  const double mixed = std::fma(a.low, b.high, a.high * b.low);
  DoubleWord result = double_word::ordered_sum(high.high, high.low + mixed);
  const double through = (a.magnitude() + a.radius) * b.radius + b.magnitude() * a.radius;
  result.radius = Bounded::widened(through + (double_word::roundoff * result.magnitude() + double_word::underflow));
  return result;
}

// With q the quotient, |A / B - a / b| <= (ra + |a / b| rb) / (|b| - rb). Nothing is known where b may be zero.
inline DoubleWord operator/(const DoubleWord& a, const DoubleWord& b) {
  const double first = a.high / b.high;
  const DoubleWord taken = double_word::product(b, first);
  const double left = (a.high - taken.high) + (a.low - taken.low);
  DoubleWord result = double_word::ordered_sum(first, left / b.high);
  result.radius = std::numeric_limits<double>::infinity();
  if (!b.is_not_zero()) return result;
  const double least = (std::abs(b.high) - std::abs(b.low)) - Bounded::widened(b.radius);
  const double through = (a.radius + result.magnitude() * b.radius + double_word::underflow) / least;
  result.radius = Bounded::widened(Bounded::widened(through) + double_word::roundoff * result.magnitude());
  return result;
}

// Returns the double nearest to the true value, if all that this may be has the same.
[[nodiscard]] inline std::optional<double> certain_rounding(const DoubleWord& a) {
  const double size = std::abs(a.high);
  const double to_next = size - std::nextafter(size, 0.0);  // the gap on the other side is not smaller
  if (!(Bounded::widened(std::abs(a.low) + a.radius) < to_next / 2)) return std::nullopt;
  return a.high;
}

}  // namespace sightline::inline geometry

// As Eigen is to see it: as Bounded.
template <>
struct Eigen::NumTraits<sightline::DoubleWord> : Eigen::GenericNumTraits<sightline::DoubleWord> {
  using Real = sightline::DoubleWord;
  using NonInteger = sightline::DoubleWord;
  using Nested = sightline::DoubleWord;
  using Literal = sightline::DoubleWord;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 3,
    AddCost = 24,
    MulCost = 30
  };
};

namespace sightline::inline geometry {

using DoubleWordVector = Eigen::Matrix<DoubleWord, 3, 1>;

// Exactly this vector.
[[nodiscard]] inline DoubleWordVector in_words(const Vector3& v) { return v.cast<DoubleWord>(); }
[[nodiscard]] inline DoubleWord dot(const DoubleWordVector& a, const DoubleWordVector& b) {
  return (a.x() * b.x() + a.y() * b.y()) + a.z() * b.z();
}
[[nodiscard]] inline DoubleWordVector cross(const DoubleWordVector& a, const DoubleWordVector& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

}  // namespace sightline::inline geometry
