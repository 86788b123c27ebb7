// Lines and places of the image by value: what is found in the mirror is put together from several scenes, whose ids
// mean nothing to each other.
//
// A line runs from one grid point to another, top to bottom in sweep order. A place is a grid point, or the point where
// two lines cross. Everything is exact; the same place may be known in several ways.
// Complexity: O(1) each.
#pragma once

#include <vector>

#include "sweep/segments/crossing_point.h"

namespace sightline::inline reflect {

struct ImageLine {
  ImagePoint top;
  ImagePoint bottom;
  friend constexpr bool operator==(const ImageLine&, const ImageLine&) = default;
};

struct ImagePlace {
  CrossingPoint at;  // of a grid point: the base, without an offset
  bool on_grid = false;
  ImageLine a;  // the lines that cross here, where it is no grid point
  ImageLine b;
};

[[nodiscard]] ImagePlace grid_place(const ImagePoint& p);

// Precondition: the lines are not parallel.
[[nodiscard]] ImagePlace crossing_place(const ImageLine& a, const ImageLine& b);

// Returns -1 where the first comes first in sweep order, 0 where they are one point.
[[nodiscard]] int sweep_compare(const ImagePlace& a, const ImagePlace& b);

// Returns +1 where p is right of the line, as the sweep line meets it; 0 where it is on it or on its continuation.
[[nodiscard]] Sign side(const ImageLine& line, const ImagePlace& p);

// Returns +1 where, below a common point, a lies left of b; 0 where they are parallel.
[[nodiscard]] Sign turn(const ImageLine& a, const ImageLine& b);

// The border of a region of the image consists of directed segments, which have the region to their left.
struct BorderSegment {
  ImagePlace start;
  ImagePlace end;
  ImageLine line;  // that it lies on
};
using RegionBorder = std::vector<BorderSegment>;

}  // namespace sightline::inline reflect
