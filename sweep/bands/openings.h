// Where visible segments open: the order in which a sweep of the whole would have found them.
//
// In:  the segments of bands' sweeps, in the whole's points, and the scene with the roles of its facets: along the
//      edges of plain ones, segments open that no sweep has found.
// Out: what opens at a row of the scene's points, and at crossings before each of them, from left to right.
// Complexity: O(n log n) in what opens.
#pragma once

#include <span>
#include <vector>

#include "sweep/bands/bands.h"
#include "sweep/fast/continuation.h"
#include "sweep/fast/roles.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

struct Opening {
  VisibleSegment segment;
  BandId band;      // invalid: of a plain facet
  SegmentId swept;  // its number in the band's sweep
  bool left_of_edge = false;

  // Left of its edge a segment runs upwards.
  [[nodiscard]] PointId upper() const { return left_of_edge ? segment.end : segment.start; }
};

// Returns what opens at points [begin, end). `from_bands` has what opens in the bands, from the first that may open
// there on, in the order in which it opens; what opens at one point in one band already goes from left to right.
[[nodiscard]] std::vector<Opening> openings_at(const ProjectedScene& scene, const Continuation& continuation,
                                               const std::vector<Role>& roles, const SweepOrder& order,
                                               std::span<const Opening> from_bands, std::size_t begin, std::size_t end);

}  // namespace sightline::inline sweep
