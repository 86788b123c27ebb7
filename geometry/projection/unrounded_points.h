// The points of a projected scene, where they are.
//
// In:  a scene whose polygons and corners are known, and per vertex in view its place with a proven radius.
// Out: its points, numbered: corners have one point only where they fall on each other exactly. Per point its place in double
//      with a proven radius, and, for whoever asks, exactly. The scene's own points are these places on the grid, for those
//      who only look.
// Complexity: O(n log n), and an exact place, in integers of any size, wherever two corners are not known to be apart.
// Source: docs/design.md, section 9.
#pragma once

#include "geometry/projection/clipping.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline geometry {

void number_unrounded_points(ProjectedScene& scene, const std::vector<CertifiedPlace>& of_vertices);

// Returns the exact place of a point, in the window's units; of any scene. It is computed anew each time.
[[nodiscard]] ExactPlace exact_place(const ProjectedScene& scene, PointId p);
[[nodiscard]] ExactPlace exact_place(const ProjectedScene& scene, PointId p, ExactCorners& corners);

}  // namespace sightline::inline geometry
