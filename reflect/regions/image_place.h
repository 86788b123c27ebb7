// Lines and places of the image by value: what is found in the mirror is put together from several scenes, whose ids
// mean nothing to each other.
//
// A line runs from one grid point to another, top to bottom in sweep order; or it is that of an edge of an image that is not
// rounded. A place is a grid point, the point where two lines cross, or a point of an image that is not rounded. Everything
// is exact; the same place may be known in several ways.
// Complexity: O(1) each.
#pragma once

#include <vector>

#include "sweep/segments/crossing_point.h"
#include "sweep/segments/image_points.h"

namespace sightline::inline reflect {

struct ImageLine {
  ImagePoint top;
  ImagePoint bottom;
  const ImagePoints* image = nullptr;  // not null: the line is that of this edge of it, and has no grid points
  EdgeId edge;
  friend constexpr bool operator==(const ImageLine&, const ImageLine&) = default;
};

struct ImagePlace {
  CrossingPoint at;  // of a grid point: the base, without an offset; of what is not on the grid's lines: x and y only
  bool on_grid = false;
  ImageLine a;  // the lines that cross here, where it is no grid point and no point of an image
  ImageLine b;
  const ImagePoints* image = nullptr;  // not null: the place is that of this point of it
  PointId point;
  double radius = crossing_error;  // of x and y, in spacings
};

[[nodiscard]] ImagePlace grid_place(const ImagePoint& p);

// Returns the place of a point of an image, on the grid or not; the image outlives it where it is not.
[[nodiscard]] ImagePlace image_place(const ImagePoints& image, PointId p);
[[nodiscard]] ImageLine image_line(const ImagePoints& image, EdgeId e);

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
