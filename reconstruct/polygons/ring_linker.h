// Links the visible segments of one surface to rings.
//
// In:  the visible segments, and how their edges turn; the ids of those of one surface.
// Out: walks: closed chains of segments, each cut into rings that visit no point twice. A walk follows the border of
//      one connected part of what is visible, with that part on its left; where several segments leave a point it
//      takes the sharpest turn that keeps the part on the left.
// Holds: every segment is in one ring of one walk; a ring starts at its first point in sweep order; the rings of a
// walk are at most one outer ring (counter-clockwise) and holes (clockwise). A walk with an outer ring is a polygon
// with the holes that touch its border or each other; a walk without one is a cluster of touching holes (mostly one
// hole), which a thread leads to its polygon.
// Complexity: O(m log m).
// Errors: InternalError where the segments do not balance at a point.
// Source: Fang 1993, 5.3.1, "Polygon Reconstruction".
#pragma once

#include <boost/container/small_vector.hpp>
#include <span>
#include <vector>

#include "sweep/segments/edge_turns.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline reconstruct {

struct LinkedRing {
  std::vector<SegmentId> segments;
  bool outer = false;
};

struct Walk {
  std::vector<LinkedRing> rings;  // the outer ring first, if there is one
  PointId top;                    // the first point in sweep order
  [[nodiscard]] bool has_outer() const { return !rings.empty() && rings.front().outer; }
};

// A few segments may be one ring which visits no point twice, as most surfaces have. They are in ring order from the
// first point in sweep order on; the ring is empty where they are not one.
using SmallRing = boost::container::small_vector<SegmentId, 8>;
struct SingleRing {
  SmallRing segments;
  bool outer = false;
};
[[nodiscard]] SingleRing single_ring(const EdgeTurns& turns, const SweepOrder& order, const VisibleSegments& segments,
                                     std::span<const SegmentId> of_surface);

[[nodiscard]] std::vector<Walk> link_rings(const EdgeTurns& turns, const SweepOrder& order,
                                           const VisibleSegments& segments, std::span<const SegmentId> of_surface);

}  // namespace sightline::inline reconstruct
