// The sides of shapes that are not horizontal, as the decomposition into slabs needs them.
//
// In:  shapes, the first of which is the frame. Out: what matters within the frame's bounding box.
// Complexity: O(n^2) for n sides.
#pragma once

#include <vector>

#include "oracle/truth/covered_area.h"
#include "oracle/truth/fraction.h"

namespace sightline::oracle::image {

// Crossing it from left to right adds `winding` to its shape's winding number.
struct Rise {
  Line line;  // a > 0, reduced: two rises on one line have equal lines
  Fraction bottom;
  Fraction top;
  Key left = 0;  // of its least and greatest x
  Key right = 0;
  std::size_t shape = 0;
  int winding = 0;
};

// Returns the rises of the shapes that reach the frame's range of y and are not wholly to the right of it.
[[nodiscard]] std::vector<Rise> rises_of(const std::vector<Shape>& shapes);

// Returns, in ascending order and once each, the y of all ends and crossings of rises in the frame's box, its own ends
// included. Some of these may be the heights of no end and no crossing.
[[nodiscard]] std::vector<Fraction> heights_of(const std::vector<Rise>& rises);

}  // namespace sightline::oracle::image
