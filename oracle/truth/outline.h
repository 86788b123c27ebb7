// Closed polygons of the image know the line of each of their sides, so that cutting them makes no number longer: a
// cut's corner is the meeting point of two lines that are known.
//
// Corners may have any w while the view volume is not yet cut out; a side is then the projective segment of points that
// are positive sums of its ends (Fang 5.2.3). What is covered is where the winding number is positive.
#pragma once

#include <vector>

#include "oracle/truth/image.h"

namespace sightline::oracle::image {

// A side goes from its start to the next side's start. The line has the direction of the way; it is zero where the ends
// are equal.
struct Side {
  Point start;
  Line line;
};
using Outline = std::vector<Side>;

[[nodiscard]] Outline outline_of(const std::vector<Point>& corners);

// Returns the part with form >= 0. A concave outline may come back with pieces joined along the cut, where its border
// runs to and fro: the winding number is still right. Source: Sutherland and Hodgman.
[[nodiscard]] Outline cut(const Outline& outline, const Line& form);

// Returns the part in the window [-1, 1]^2 and not behind the eye.
[[nodiscard]] Outline cut_to_window(const Outline& outline);

// Returns the window itself, counter-clockwise.
[[nodiscard]] Outline window();

}  // namespace sightline::oracle::image
