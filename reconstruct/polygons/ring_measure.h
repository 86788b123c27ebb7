// The area and perimeter of rings of visible segments: in double with a proven bound of the error, and the area
// exactly.
//
// In:  the points of a sweep's result, its segments, and rings as lists of segments that chain.
// Out: measures in grid units. Bound, with u = 2^-53: a point's coordinates are off by at most crossing_error, so a
//      difference of two, below 2^42 and rounded itself, is off by at most e = 2 * crossing_error + 2^-11. A term ux
//      * vy - uy * vx of the area is then off by at most e * (|ux| + |uy| + |vx| + |vy|) + 2 * e^2 + 2 * u * (|ux *
//      vy| + |uy * vx|), and a sum of n terms by n * u times the sum of their absolute values more. A length is off
//      by at most 2 * e and 2 * u of itself.
// Complexity: O(n); the exact area O(n log n) multiplications of integers that grow to O(n) digits.
#pragma once

#include <span>

#include "sweep/segments/image_points.h"

namespace sightline::inline reconstruct {

struct RingMeasure {
  double twice_area = 0;  // counter-clockwise positive
  double perimeter = 0;

  // These sums, over all terms, bound the errors.
  double differences = 0;  // |ux| + |uy| + |vx| + |vy|
  double products = 0;     // |ux * vy| + |uy * vx|
  std::size_t terms = 0;

  RingMeasure& operator+=(const RingMeasure& other);
  [[nodiscard]] double area_error() const;  // of twice_area
  [[nodiscard]] double perimeter_error() const;
};

[[nodiscard]] RingMeasure measure(const ImagePoints& points, const VisibleSegments& segments,
                                  std::span<const SegmentId> ring);

// This is twice the area, not reduced; the denominator is positive.
struct ExactArea {
  BigInteger numerator = 0;
  BigInteger denominator = 1;
};
[[nodiscard]] ExactArea exact_twice_area(const ImagePoints& points, const VisibleSegments& segments,
                                         std::span<const SegmentId> rings);

// Returns the sign of a ring's area, exactly.
[[nodiscard]] Sign area_sign(const ImagePoints& points, const VisibleSegments& segments,
                             std::span<const SegmentId> ring);

}  // namespace sightline::inline reconstruct
