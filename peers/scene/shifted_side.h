// On which side of a line a point is, for lines that are moved by an infinitesimal step: never on it.
//
// Lines whose visibility is asked for are thought moved to the right, and infinitely less upwards. Whatever lies on
// them in the image, vertices and other edges, is then to one side of them, always the same one: nothing is counted
// twice or not at all. Exact on the coordinates given.
// Source: Edelsbrunner and Mücke 1990, Simulation of Simplicity.
#pragma once

#include "geometry/numbers/predicates.h"

namespace sightline::peers {

// Returns the side of the line from a to b on which p lies when it is moved by the step: +1 to the left, -1 to the
// right.
[[nodiscard]] inline Sign side_of_moved_point(const Point2& a, const Point2& b, const Point2& p) {
  const Sign side = orient2d(a, b, p);
  if (side != 0) return side;
  if (a.y != b.y) return b.y > a.y ? -1 : 1;
  return b.x > a.x ? 1 : -1;
}

// Returns the side on which p lies when the line is moved by the step.
[[nodiscard]] inline Sign side_of_moved_line(const Point2& a, const Point2& b, const Point2& p) {
  const Sign side = orient2d(a, b, p);
  return side != 0 ? side : -side_of_moved_point(a, b, p);
}

}  // namespace sightline::peers
