// How near and how far what is in view of each facet is.
//
// In:  a mesh and its projected scene.
// Out: per facet an interval that contains the depths (along the view direction) of its polygon in the view volume,
//      with all errors of rounding; empty for a facet that is not in view.
// Holds: where a facet's interval lies behind another's, the other is in front wherever both are in the image.
// Complexity: O(n).
#pragma once

#include <limits>
#include <vector>

#include "geometry/numbers/export.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

struct DepthRange {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -std::numeric_limits<double>::infinity();
};

[[nodiscard]] SIGHTLINE_EXPORT std::vector<DepthRange> depth_ranges(const ProjectedScene& scene);

}  // namespace sightline::inline sweep
