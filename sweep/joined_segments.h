// The visible segments of a scene from those of its open facets and the patches that are seen.
//
// In:  what the sweep of a part of the scene has found, in the ids of the whole; the roles of facets.
// Out: what the sweep of the whole finds, in the same order.
// Holds: only what the part's sweep says of open facets is used, and where it borders on patches, whether they are seen.
// Complexity: O(n log n).
// Errors: InternalError where a patch seems to be seen from one of its borders and not from another, with a facet of it.
#pragma once

#include "geometry/projected_scene.h"
#include "sweep/continuation.h"
#include "sweep/patches.h"
#include "sweep/visible_segments.h"

namespace sightline {

[[nodiscard]] VisibleSegments join_segments(const ProjectedScene& scene, const Continuation& continuation,
                                            const Patches& patches, const VisibleSegments& swept);

}  // namespace sightline
