// Do the visible segments of one surface bound what they should: regions that lie side by side.
//
// In:  segments of one surface, each on its edge (validate(segments, scene) is empty).
// Out: messages with their ids. Checked, exactly:
//   - two segments meet in end points only;
//   - the winding number of all of them is 0 to the right of a segment and 1 to its left. For closed rings that do
//     not cross this says that nothing is covered twice: polygons are apart, and holes lie in their polygons.
//     Complete for surfaces with up to 64 segments. Of a larger one each segment is held against the 64 that open
//     next after it, and the winding number is looked at beside 64 segments.
// Complexity: O(m (log m + 64)) for m segments.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sweep/segments/edge_sides.h"

namespace sightline::inline reconstruct {

void check_surface_layout(const EdgeSides& sides, const VisibleSegments& segments, std::vector<SegmentId> of_surface,
                          std::vector<std::string>& messages);

// Returns whether two segments have more in common than end points.
[[nodiscard]] bool meet_inside(const EdgeSides& sides, const VisibleSegment& s, const VisibleSegment& t);

}  // namespace sightline::inline reconstruct
