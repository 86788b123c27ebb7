// The area of a ring is positive where it runs counter-clockwise, and 0 for fewer than three corners. It is computed
// relative to the first corner.
#pragma once

#include <vector>

#include "geometry/numbers/predicates.h"

namespace sightline::peers {

[[nodiscard]] inline double signed_area(const std::vector<Point2>& ring) {
  double twice = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Point2& p = ring[i - 1];
    const Point2& q = ring[i];
    twice += (p.x - ring[0].x) * (q.y - ring[0].y) - (p.y - ring[0].y) * (q.x - ring[0].x);
  }
  return twice / 2;
}

}  // namespace sightline::peers
