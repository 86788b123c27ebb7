// Arithmetic on doubles can be exact, since any finite set of doubles is a set of integers times one common power of
// two.
//
// Signs of homogeneous polynomials in the coordinates do not change under that common factor, so every predicate that
// the filter leaves open is evaluated here in integers. Wide512 holds it without allocation where the exponents are
// near each other (the normal case); BigInteger holds anything.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <span>

namespace sightline::inline geometry {

using BigInteger = boost::multiprecision::cpp_int;
using Wide256 = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    256, 256, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;
using Wide512 = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    512, 512, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;

// A sign is -1, 0 or +1.
using Sign = int;

template <class Number>
constexpr Sign sign_of(const Number& value) {
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

// A finite double is mantissa * 2^exponent with an odd mantissa; zero is 0 * 2^0.
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

inline Dyadic dyadic(double value) {
  if (value == 0) return {};
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int zeros = __builtin_ctzll(static_cast<unsigned long long>(mantissa));
  mantissa /= std::int64_t{1} << zeros;
  return {mantissa, exponent - 53 + zeros};
}

// This is the range of the exponents of a set of doubles: every one is an integer of at most `bits` bits times
// 2^lowest.
struct ExponentRange {
  int lowest = 0;
  int bits = 0;
};

inline ExponentRange exponent_range(std::span<const double> values) {
  bool any = false;
  int lowest = 0;
  int highest = 0;
  for (const double value : values) {
    if (value == 0) continue;
    const Dyadic d = dyadic(value);
    const int top = std::ilogb(value) + 1;
    lowest = any ? std::min(lowest, d.exponent) : d.exponent;
    highest = any ? std::max(highest, top) : top;
    any = true;
  }
  return {lowest, highest - lowest};
}

// Returns value / 2^lowest, exactly; lowest is at most the exponent of value.
template <class Integer>
Integer scaled(double value, int lowest) {
  const Dyadic d = dyadic(value);
  if (d.mantissa == 0) return Integer(0);
  return Integer(d.mantissa) << static_cast<unsigned>(d.exponent - lowest);
}

template <class Integer, std::size_t N>
std::array<Integer, N> scaled(const std::array<double, N>& values, int lowest) {
  std::array<Integer, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = scaled<Integer>(values[i], lowest);
  return result;
}

// Returns the sign of polynomial(integers), where integers are `values` over their common power of two.
// `bits_needed(bits)` bounds the size of every intermediate value for inputs of that many bits.
template <std::size_t N, class Polynomial, class BitsNeeded>
Sign exact_sign(const std::array<double, N>& values, Polynomial polynomial, BitsNeeded bits_needed) {
  const ExponentRange range = exponent_range(values);
  if (bits_needed(range.bits) < 511) return sign_of(polynomial(scaled<Wide512>(values, range.lowest)));
  return sign_of(polynomial(scaled<BigInteger>(values, range.lowest)));
}

// Returns numerator / denominator rounded once to double, to nearest even. Precondition: denominator > 0. The quotient
// is taken to 66 bits or more, the last one sticky, which decides the rounding like all that follow it. A denormal
// result is rounded twice.
template <class Integer>
double rounded_quotient(const Integer& numerator, const Integer& denominator) {
  if (numerator == 0) return 0;
  const Integer magnitude = abs(numerator);
  const int shift = 67 + static_cast<int>(msb(denominator)) - static_cast<int>(msb(magnitude));
  const Integer dividend = shift > 0 ? Integer(magnitude << static_cast<unsigned>(shift)) : magnitude;
  const Integer divisor = shift < 0 ? Integer(denominator << static_cast<unsigned>(-shift)) : denominator;
  Integer quotient;
  Integer remainder;
  divide_qr(dividend, divisor, quotient, remainder);
  __extension__ using Wide = unsigned __int128;
  const Wide bits = static_cast<Wide>(quotient) | (remainder != 0 ? 1U : 0U);
  const double rounded = std::ldexp(static_cast<double>(bits), -shift);
  return numerator < 0 ? -rounded : rounded;
}

}  // namespace sightline::inline geometry
