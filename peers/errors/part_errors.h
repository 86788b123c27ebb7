// The errors of visible parts: their areas together with the exact polygons.
//
// Out: wrong_share is what is wrongly shown over nothing, and of the rest the larger of what is missing of the right
//      faces and what is shown of wrong ones. Where a peer's parts do not overlap that is the area with the wrong
//      label; where they do, each face too many counts.
// Method: a ring is the signed sum of the triangles between its first corner and its sides; what a triangle has in
//      common with another ring is that ring, clipped to it (Sutherland and Hodgman 1974).
// Complexity: O(corners x corners) of the rings whose boxes meet.
#pragma once

#include "peers/scene/errors_of_areas.h"
#include "peers/scene/exact_parts.h"

namespace sightline::peers {

[[nodiscard]] AreaErrors errors_of(const VisibleParts& seen, const ExactParts& exact);

// Returns the area that two rings have in common, signed by both their directions.
[[nodiscard]] double common_area(const std::vector<Point2>& a, const std::vector<Point2>& b);

}  // namespace sightline::peers
