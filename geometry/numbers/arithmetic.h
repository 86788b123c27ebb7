// The dial: in which arithmetic a view is decided, and on which grid of the image.
//
//   single_precision, double_precision: every decision of projection, sweep and depth is a plain evaluation in that
//     type, with no error bound and nothing behind it. Best effort: the outcome is a result, or an ArithmeticError that
//     says which invariant broke. It ends on every input.
//   exact: no decision is ever rounded; the points of the image are, once, to the grid. What a stage does
//     that is called by itself, unless it is told otherwise.
//   unrounded: nothing is rounded before it is written, and facets may pass through each other. There is no grid. What an
//     Analyzer and the command do unless they are told otherwise.
// What is exact in all of them: reading, cutting along common lines and the order of the pieces, which facets are clipped
// and where (clipping.h), which facets the eye sees edge-on, and what is computed from the sweep's result, where a
// crossing is the pair of edges that makes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "geometry/numbers/errors.h"
#include "geometry/numbers/export.h"
#include "geometry/numbers/image_point.h"

namespace sightline::inline geometry {

enum class Arithmetic : std::uint8_t { single_precision, double_precision, exact, unrounded };

// Returns whether decisions are never rounded.
[[nodiscard]] constexpr bool is_exact(Arithmetic arithmetic) { return arithmetic >= Arithmetic::exact; }

// The names are "float", "double", "exact" and "unrounded".
[[nodiscard]] SIGHTLINE_EXPORT const char* to_string(Arithmetic arithmetic);
[[nodiscard]] SIGHTLINE_EXPORT std::optional<Arithmetic> arithmetic_named(std::string_view name);

// The grid of the image has 2^grid_bits cells in the half window.
struct Precision {
  Arithmetic arithmetic = Arithmetic::exact;
  int grid_bits = default_grid_bits;  // in [smallest_grid_bits, default_grid_bits]
};

constexpr int smallest_grid_bits = 8;

// Returns the value of `work`. An invariant that does not hold is a defect of sightline where the arithmetic is exact
// (InternalError), and the arithmetic's doing where it is not (ArithmeticError).
template <class Work>
auto with_invariants_of(Arithmetic arithmetic, Work work) {
  try {
    return work();
  } catch (const InternalError& error) {
    if (is_exact(arithmetic)) throw;
    throw ArithmeticError(to_string(arithmetic), error.what());
  }
}

}  // namespace sightline::inline geometry
