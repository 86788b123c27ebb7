// Trapezoidal decomposition of the image by brute force: horizontal slabs between all distinct y of corners and
// crossings.
//
// In:  rings in oracle units, |coordinate| <= 2 * half_window; a ring may touch itself, inside is even-odd.
// Out: every trapezoid between neighbouring edges of a slab, slabs bottom to top, trapezoids left to right, with the
// rings
//      that contain it. No edges cross inside a slab, so what holds in a trapezoid's middle holds in all of it.
// Sizes: corners have 11 bits, differences 12; y = n / d has 36 / 25 bits, the middle of a slab 62 / 51; everything
// fits 128 bits. Complexity: O(n^2) crossings, O(n) edges in each of O(n^2) slabs.
#pragma once

#include <vector>

#include "oracle/lattice/camera_space.h"

namespace sightline::lattice {

// The denominator is > 0.
struct Fraction {
  Int128 numerator = 0;
  Int128 denominator = 1;
};
[[nodiscard]] bool operator<(const Fraction& a, const Fraction& b);
[[nodiscard]] bool operator==(const Fraction& a, const Fraction& b);

// A place in the image is (x / denominator, y / denominator), denominator > 0.
struct Place {
  Int128 x = 0;
  Int128 y = 0;
  Int128 denominator = 1;
};

// A rise is a piece of a ring that is not horizontal.
struct Rise {
  GridPoint bottom;
  GridPoint top;
  std::size_t ring = 0;
};

[[nodiscard]] Place place_on(const Rise& rise, const Fraction& y);
// Returns the middle of two places in the middle of a slab; their rises have |coordinate| <= half_window (114 bits
// then).
[[nodiscard]] Place middle(const Place& a, const Place& b);

struct Trapezoid {
  std::size_t left = 0;  // the lowest of the rises that coincide there
  std::size_t right = 0;
  std::vector<std::size_t> inside;  // rings, ascending
};

struct Slab {
  Fraction bottom;
  Fraction top;
  std::vector<Trapezoid> trapezoids;
};

struct Decomposition {
  std::vector<Rise> rises;
  std::vector<Slab> slabs;
};

[[nodiscard]] Decomposition decompose(const std::vector<Ring>& rings);

// Returns the y of the point where two rises cross or touch, unless they are parallel.
[[nodiscard]] std::optional<Fraction> crossing_height(const Rise& a, const Rise& b);

}  // namespace sightline::lattice
