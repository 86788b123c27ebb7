// The lines that are exactly visible: where the boundary of what is visible of a face runs along an edge of the mesh.
//
// Out: each point of an edge of the scene once, whichever of its faces' segments run along it. Not along the window's
//      border, which is no edge.
// Complexity: O(m log m) for m visible segments.
#pragma once

#include "peers/scene/seen.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::peers {

[[nodiscard]] VisibleLines exact_lines(const ProjectedScene& scene, const VisibleSegments& segments);

}  // namespace sightline::peers
