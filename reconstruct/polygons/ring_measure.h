// The area and perimeter of rings of visible segments: in double with a proven bound of the error, and the area
// exactly.
//
// In:  the points of a sweep's result, its segments, and rings as lists of segments that chain.
// Out: measures in the window's units, with their radius: a point's coordinates are off by a radius of their own. A
//      difference of two is off by both, and rounds; a length is off by the radii of both coordinates, and by 2 u of itself (u = 2^-53). What follows from it is Bounded's.
// Complexity: O(n); the exact area O(n log n) multiplications of integers that grow to O(n) digits.
#pragma once

#include <span>

#include "geometry/numbers/bounded.h"
#include "sweep/segments/image_points.h"

namespace sightline::inline reconstruct {

struct RingMeasure {
  Bounded twice_area;  // counter-clockwise positive
  Bounded perimeter;

  RingMeasure& operator+=(const RingMeasure& other);
};

[[nodiscard]] RingMeasure measure(const ImagePoints& points, const VisibleSegments& segments,
                                  std::span<const SegmentId> ring);

// Returns whether a polygon of a surface with this area and perimeter, in the window's units, is below resolution: narrower
// than a spacing of the grid, twice the area over the perimeter being the width. Without rounding a surface may itself be
// seen so narrow, nearly edge-on; then what is at least a thousandth of its width is above resolution.
[[nodiscard]] bool is_below_resolution(const ProjectedScene& scene, FacetId surface, double area, double perimeter);

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
