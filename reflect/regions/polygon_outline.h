// A polygon of the image against squares, in floating point: may they have a border in common?
//
// In:  the polygon's border. Out: whether a square is certainly outside, certainly inside, or perhaps across the
//      border.
// Complexity: O(n) per square for n segments.
#pragma once

#include <vector>

#include "geometry/numbers/predicates.h"
#include "reflect/regions/image_place.h"

namespace sightline::inline reflect {

enum class SquarePlace : std::uint8_t { outside, across, inside };

class PolygonOutline {
 public:
  explicit PolygonOutline(const RegionBorder& border);

  [[nodiscard]] SquarePlace place_of(const ImagePoint& low, std::int64_t size) const;

  struct Side {
    Point2 start;
    Point2 end;

    // Returns the distance of p from the side's line, to the left of it.
    [[nodiscard]] double left_of(const Point2& p) const;
  };

 private:
  [[nodiscard]] int winding(const Point2& p) const;

  std::vector<Side> sides_;
};

}  // namespace sightline::inline reflect
