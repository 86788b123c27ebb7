// A scene with some of its facets only, and the way back to the whole.
//
// In:  a projected scene and the facets to keep.
// Out: a valid projected scene of these. Facets keep their ids; points and edges are numbered anew, in the same order.
//      in_whole() gives what the sweep of the part has found in the ids of the whole.
// Complexity: O(n) to look at all facets and edges, and O(m log m) for the m that are kept.
#pragma once

#include <vector>

#include "geometry/projected_scene.h"
#include "sweep/visible_segments.h"

namespace sightline {

struct ScenePart {
  ProjectedScene scene;
  std::vector<PointId> point;  // per point of the part: its id in the whole
  std::vector<EdgeId> edge;    // per edge of the part
};

[[nodiscard]] ScenePart part_of(const ProjectedScene& whole, const std::vector<std::uint8_t>& kept);

[[nodiscard]] VisibleSegments in_whole(const ProjectedScene& whole, const ScenePart& part, VisibleSegments segments);

}  // namespace sightline
