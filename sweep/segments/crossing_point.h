// The point where two edges cross, exactly.
//
// In:  two edges of the scene that cross in one point.
// Out: the point as a fraction; its order against vertices and other crossings.
// Sizes: with coordinates of 41 bits and a sign, a difference d has |d| <= 2^41, so
//   denominator = d1 x d2               |.| <= 2^83
//   numerator   = (p2 - p1) x d2        |.| <= 2^83
//   offset      = d1 * numerator        |.| <= 2^124
// and a comparison with a vertex stays below 2^125: 128 bits do. Two crossings compare in 2^210: 256 bits, behind a
// filter.
// Symmetry: the point does not depend on the order of the two edges.
#pragma once

#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

struct CrossingPoint {
  ImagePoint base;  // the point is base + offset / denominator
  Int128 offset_x = 0;
  Int128 offset_y = 0;
  Int128 denominator = 1;  // > 0
  double x = 0;            // the point rounded: off by at most crossing_error
  double y = 0;
};

// The quotient offset / denominator has a relative error of 3 u (two conversions, a division) and is at most 2^41;
// adding the base rounds by u * 2^41 once more: 4 * 2^41 * 2^-53 in all.
constexpr double crossing_error = 0x1p-10;

// What lies further apart than this, rounded, is in that order: two errors, and the subtraction's rounding of at most
// u * 2^42.
constexpr double crossing_order_bound = 2 * crossing_error + 0x1p-11;

// Precondition: the edges are not parallel.
[[nodiscard]] CrossingPoint crossing_point(const ImagePoint& top_a, const ImagePoint& bottom_a, const ImagePoint& top_b,
                                           const ImagePoint& bottom_b);

// Precondition: the two edges of the scene are not parallel.
[[nodiscard]] CrossingPoint crossing_point(const ProjectedScene& scene, EdgeId a, EdgeId b);

// Returns whether the ends of each edge lie strictly on different sides of the other, exactly.
[[nodiscard]] bool cross_inside_both(const ProjectedScene& scene, EdgeId a, EdgeId b);

// Returns the same point's y.
[[nodiscard]] double crossing_height(const ImagePoint& top_a, const ImagePoint& bottom_a, const ImagePoint& top_b,
                                     const ImagePoint& bottom_b);

// Compares in sweep order: -1 where the first comes first, 0 where they are one point.
[[nodiscard]] int sweep_compare(const CrossingPoint& crossing, const ImagePoint& point);
[[nodiscard]] int sweep_compare(const CrossingPoint& a, const CrossingPoint& b);

namespace crossing_tiers {
[[nodiscard]] int exact(const CrossingPoint& a, const CrossingPoint& b);
}

}  // namespace sightline::inline sweep
