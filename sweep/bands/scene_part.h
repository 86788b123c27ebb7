// A scene with some of its facets only, and the way back to the whole.
//
// In:  a projected scene, where its surface continues, and the facets to keep, by their ids.
// Out: a valid projected scene of these. Facets keep their ids; points and edges are numbered anew, in the same order.
//      Vertices have no weights, which no sweep asks for.
//      in_whole() gives what the sweep of the part has found in the ids of the whole.
// Complexity: O(n), of which all but the m facets that are kept cost a few bytes each.
#pragma once

#include <span>
#include <vector>

#include "geometry/projection/projected_scene.h"
#include "sweep/fast/continuation.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

struct ScenePart {
  ProjectedScene scene;
  std::vector<PointId> point;  // per point of the part: its id in the whole
  std::vector<EdgeId> edge;    // per edge of the part
};

[[nodiscard]] ScenePart part_of(const ProjectedScene& whole, const Continuation& continuation,
                                std::span<const FacetId> kept);

[[nodiscard]] VisibleSegments in_whole(const ProjectedScene& whole, const ScenePart& part, VisibleSegments segments);

}  // namespace sightline::inline sweep
