// This is the part of validate(segments, scene) that looks at the crossings.
//
// It checks exactly, with the scene's points alone, that a crossing is of two edges that cross strictly inside both,
// that its place among the scene's points is the one it names, and that crossings follow each other in sweep order.
// Everything else may rely on this.
#pragma once

#include <string>
#include <vector>

#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

// Returns whether the ends of each edge lie strictly on different sides of the other, exactly.
[[nodiscard]] bool cross_inside_both(const ProjectedScene& scene, EdgeId a, EdgeId b);

[[nodiscard]] inline std::string crossing_name(std::size_t crossing) { return "crossing " + std::to_string(crossing); }

// Appends a message, with ids, for each crossing that does not hold this. Precondition: ids are in range.
void check_crossings(const VisibleSegments& segments, const ProjectedScene& scene, std::vector<std::string>& messages);

}  // namespace sightline::inline sweep
