// Points of the image are rounded once to the grid, and the planar predicates on them are exact.
//
// The window [-1, 1]^2 is [-2^b, 2^b]^2 in grid units for b grid bits (40 by default), so a coordinate has at most 41
// bits and a sign, a difference 42, an orientation 2 * 42 + 1: everything here fits 128 bits.
//
// The sweep order goes top to bottom (y descending), then left to right (x ascending). It tilts the sweep line by an
// infinitesimal angle, so that horizontal edges need no special treatment (Fang's appendix B rotates them away).
#pragma once

#include <cstdint>

#include "geometry/numbers/exact_integer.h"

namespace sightline::inline geometry {

__extension__ using Int128 = __int128;

constexpr int default_grid_bits = 40;

struct ImagePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend constexpr bool operator==(const ImagePoint&, const ImagePoint&) = default;
};

// Returns whether a is before b in sweep order.
constexpr bool sweeps_before(const ImagePoint& a, const ImagePoint& b) { return a.y != b.y ? a.y > b.y : a.x < b.x; }

// Returns twice the signed area of a, b, c.
constexpr Int128 twice_area(const ImagePoint& a, const ImagePoint& b, const ImagePoint& c) {
  return static_cast<Int128>(b.x - a.x) * (c.y - a.y) - static_cast<Int128>(b.y - a.y) * (c.x - a.x);
}

// Returns +1 where a, b, c turn counter-clockwise. Swapping two arguments flips the sign.
constexpr Sign orientation(const ImagePoint& a, const ImagePoint& b, const ImagePoint& c) {
  return sign_of(twice_area(a, b, c));
}

}  // namespace sightline::inline geometry
