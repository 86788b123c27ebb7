// The visible segments of a scene from those of its open facets and those along the edges of its plain ones.
//
// In:  what the sweep of each band has found, in the ids of the whole; the roles of facets.
// Out: what the sweep of the whole finds, in the same order; the statistics are sums over the bands.
// Holds: only what a band's sweep says of its own open facets is used.
// Complexity: O(n log n).
#pragma once

#include <vector>

#include "sweep/bands/bands.h"
#include "sweep/fast/roles.h"
#include "sweep/fast/scene_in_cells.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

[[nodiscard]] VisibleSegments join_segments(const SceneInCells& in, const std::vector<Role>& roles, const Bands& bands,
                                            std::vector<VisibleSegments> swept);

}  // namespace sightline::inline sweep
