// Fractions are mostly compared: by their first binary places, and exactly where these are equal.
#pragma once

#include <cstdint>

#include "oracle/truth/image.h"

namespace sightline::oracle::image {

// A key has 60 binary places: those of a number in [-1, 1] fit 64 bits. Beyond [-4, 4] all numbers of one sign have the
// same.
constexpr unsigned key_places = 60;
using Key = std::int64_t;

// Returns top / bottom * 2^key_places, rounded down; bottom > 0.
[[nodiscard]] Key key_of(const Integer& top, const Integer& bottom);

struct Fraction {
  Integer top;
  Integer bottom{1};  // > 0
  Key key = 0;
};
[[nodiscard]] Fraction fraction(Integer top, Integer bottom);

[[nodiscard]] bool operator<(const Fraction& a, const Fraction& b);
[[nodiscard]] bool operator==(const Fraction& a, const Fraction& b);

// Returns some number strictly between, for a < b.
[[nodiscard]] Fraction between(const Fraction& a, const Fraction& b);

}  // namespace sightline::oracle::image
