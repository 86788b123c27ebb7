// How much memory the stages of one view need, before they run.
//
// In:  the mesh and its projected scene. Out: an upper bound for scenes whose edges cross seldom.
#pragma once

#include <cstdint>

#include "geometry/projected_scene.h"

namespace sightline {

[[nodiscard]] std::uint64_t memory_for_view(const Mesh& mesh, const ProjectedScene& scene);

// Throws MemoryError where that is above the limit.
void require_memory_for_view(const Mesh& mesh, const ProjectedScene& scene, std::uint64_t limit);

}  // namespace sightline
