// How much memory the sweep of one view and all that follows need, before they run.
//
// In:  the mesh and its projected scene. Out: a measured upper bound (memory_estimate.cpp says how) for what the counts
//      can tell: views with no more visible segments than two per edge. What more crossings make visible only the sweep
//      finds out; --max-memory then ends it (memory_limit.h).
#pragma once

#include <cstdint>

#include "geometry/projection/projected_scene.h"

namespace sightline::cli {

[[nodiscard]] std::uint64_t memory_for_view(const ProjectedScene& scene);

// Throws MemoryError where that is above the limit.
void require_memory_for_view(const ProjectedScene& scene, std::uint64_t limit);

}  // namespace sightline::cli
