// A rational number times a power of two, as the double nearest to it.
//
// In:  numerator / denominator * 2^exponent, denominator > 0.
// Out: the nearest double, of two that are as near the even one, also where it is denormal; an infinity beyond the range.
// Complexity: that of one division of the integers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/numbers/exact_integer.h"

namespace sightline::inline geometry {

namespace exact_rounding {

constexpr int digits = std::numeric_limits<double>::digits;
constexpr int lowest_bit = std::numeric_limits<double>::min_exponent - digits;  // of the last bit of a denormal

}  // namespace exact_rounding

// The quotient is taken to the digits that the result has and at least two more, of which the last is sticky.
inline double rounded_ratio(const BigInteger& numerator, const BigInteger& denominator, int exponent) {
  if (numerator == 0) return 0;
  const BigInteger magnitude = abs(numerator);
  // The quotient is at least 2^(top - 1), and below 2^(top + 1).
  const int top = static_cast<int>(msb(magnitude)) - static_cast<int>(msb(denominator));
  // What the last bit of `bits` is worth.
  const int last = std::max(top + exponent - exact_rounding::digits, exact_rounding::lowest_bit) - 2;
  const int shift = exponent - last;
  if (shift < -top - 2) return numerator < 0 ? -0.0 : 0.0;
  const BigInteger dividend = shift > 0 ? BigInteger(magnitude << static_cast<unsigned>(shift)) : magnitude;
  const BigInteger divisor = shift < 0 ? BigInteger(denominator << static_cast<unsigned>(-shift)) : denominator;
  BigInteger bits;
  BigInteger rest;
  divide_qr(dividend, divisor, bits, rest);
  auto integer = static_cast<std::uint64_t>(bits);
  integer |= rest != 0 ? 1U : 0U;
  // The double keeps 53 of these bits, or where it is denormal all but two.
  int dropped = 2;
  while (integer >> dropped >= std::uint64_t{1} << exact_rounding::digits) ++dropped;
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  const std::uint64_t tail = integer & (2 * half - 1);
  std::uint64_t kept = integer >> dropped;
  if (tail > half || (tail == half && (kept & 1U) != 0)) ++kept;
  const double rounded = std::ldexp(static_cast<double>(kept), last + dropped);
  return numerator < 0 ? -rounded : rounded;
}

}  // namespace sightline::inline geometry
