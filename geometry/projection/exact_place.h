// Places and lines of the image that are not rounded: places known in double up to a radius, and both exactly.
#pragma once

#include <optional>

#include "geometry/numbers/exact_integer.h"
#include "geometry/numbers/image_point.h"
#include "geometry/projection/clipping.h"

namespace sightline::inline geometry {

// The true place is within the radius in each coordinate, in the window's units.
struct CertifiedPlace {
  double x = 0;
  double y = 0;
  double radius = 0;
};

// Places that may be further off than this are worked out with more bits, and rounded: filters then decide as much of them as of
// others.
constexpr double largest_radius = 0x1p-46;

// Returns the grid point that a place is near, within a spacing.
[[nodiscard]] ImagePoint near_grid_point(const CertifiedPlace& place, int grid_bits);

// The place (x / w, y / w), w > 0, in the window's units.
struct ExactPlace {
  BigInteger x, y, w;
};

[[nodiscard]] ExactPlace place_of(const ExactCorner& corner);

// Compares in sweep order: -1 where the first comes first, 0 where they are one place.
[[nodiscard]] int sweep_compare(const ExactPlace& a, const ExactPlace& b);

// The line a x + b y + c w = 0.
struct ExactLine {
  BigInteger a, b, c;
};

[[nodiscard]] ExactLine line_through(const ExactPlace& top, const ExactPlace& bottom);
// Returns +1 where the place is right of the line, 0 where it is on it.
[[nodiscard]] Sign side(const ExactLine& line, const ExactPlace& place);
// Returns +1 where, below a common point, a lies left of b; 0 where they are parallel. Both run downwards.
[[nodiscard]] Sign turn(const ExactLine& a, const ExactLine& b);
// Precondition: the lines are not parallel.
[[nodiscard]] ExactPlace meeting_place(const ExactLine& a, const ExactLine& b);

// These return +1 where a, b, c turn counter-clockwise; the first nothing where their radii leave that open.
[[nodiscard]] std::optional<Sign> certain_orientation(const CertifiedPlace& a, const CertifiedPlace& b,
                                                      const CertifiedPlace& c);
[[nodiscard]] Sign orientation(const ExactPlace& a, const ExactPlace& b, const ExactPlace& c);

// Returns the place with each coordinate rounded once.
[[nodiscard]] CertifiedPlace certified(const ExactPlace& place);

}  // namespace sightline::inline geometry
