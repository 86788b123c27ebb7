// A measured number, or what is known of it where measuring had to stop.
//
// In:  outcomes of runs, and other figures.
// Out: figures, their text for a table, and whether they reach a goal.
// Holds: what follows from a bound is a bound: a time above the limit makes a ratio that is above or below something.
// Complexity: O(1). Errors: none; what cannot be known is `unknown`.
#pragma once

#include <cstdint>
#include <string>

#include "bench/measuring/limited_run.h"

namespace sightline::bench {

struct Figure {
  enum class Kind : std::uint8_t {
    exactly,
    above,          // the value is a lower bound
    below,          // the value is an upper bound
    unknown,        // not measured, or nothing follows
    not_installed,  // of a rival
    failed,
  };
  Kind kind = Kind::unknown;
  double value = 0;
};

[[nodiscard]] constexpr Figure exactly(double value) { return {Figure::Kind::exactly, value}; }

// Returns the number at `index` of what a run gave; it is above the limit where the run was out of time. A rival that
// is not installed ends without numbers.
[[nodiscard]] Figure figure_of(const Outcome& outcome, std::size_t index, const RunLimits& limits);

[[nodiscard]] Figure ratio(const Figure& a, const Figure& b);

struct Growth {
  double from = 1;
  double to = 1;
};

// Returns the exponent e with last / first = (to / from)^e.
[[nodiscard]] Figure exponent(const Figure& first, const Figure& last, const Growth& size);

// Returns three digits, or an integer, with "> " or "< " before a bound, or a word.
[[nodiscard]] std::string text_of(const Figure& figure);

struct Goal {
  enum class Sense : std::uint8_t { at_most, at_least };
  Sense sense = Sense::at_most;
  double value = 1;
};

// Returns "yes", "no", or "not known".
[[nodiscard]] std::string reached(const Figure& figure, const Goal& goal);

}  // namespace sightline::bench
