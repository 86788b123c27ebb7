// The area and perimeter of rings of visible segments: in double with a proven bound of the error, and the area
// exactly.
//
// In:  the points of a sweep's result, its segments, and rings as lists of segments that chain.
// Out: measures in the points' units, with their radius: on the grid a point's coordinates are off by at most
//      crossing_error, without rounding by a radius of their own. A difference of two is off by both, and rounds; a length is
//      off by the radii of both coordinates, and by 2 u of itself (u = 2^-53). What follows from it is Bounded's.
// Complexity: O(n); the exact area O(n log n) multiplications of integers that grow to O(n) digits.
#pragma once

#include <span>

#include "geometry/numbers/bounded.h"
#include "sweep/segments/image_points.h"
#include "sweep/unrounded/unrounded_sweep.h"

namespace sightline::inline reconstruct {

struct RingMeasure {
  Bounded twice_area;  // counter-clockwise positive
  Bounded perimeter;

  RingMeasure& operator+=(const RingMeasure& other);
};

[[nodiscard]] RingMeasure measure(const ImagePoints& points, const VisibleSegments& segments,
                                  std::span<const SegmentId> ring);

// The same without rounding, in window units.
[[nodiscard]] RingMeasure measure(const UnroundedSegments& found, std::span<const SegmentId> ring);

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
