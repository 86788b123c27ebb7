// Koucky's own test for reflections, as published: per triangle yes or no.
//
// In:  a world, the camera, the labelled surface without reflections.
// Out: the labelled surface, a triangle that is seen marked per panel where
//      1. at each of its corners the ray from the camera, mirrored at the corner's normal, meets the panel; and
//      2. in the pyramid from the camera's mirror image at the triangle's plane (C_r) through the triangle there is no
//         vertex of the surface between the triangle's plane and the panel's.
// Normals: those of the triangle, or the vertices', interpolated within their face (shading_normals.h).
// It misses, by design, a panel that is seen in part of a triangle, an obstacle without a vertex in the pyramid
// (and panels as obstacles). mirror.h has the exact answer; this is here to be compared with it.
// Floating point. Complexity: O(1) per triangle and panel where a corner misses the panel, else a search among the
// vertices.
// Source: Koucky 2014, 3.9 and algorithm 3.6. Added to it: a panel that emits to its front only, an orthographic
//      camera.
#pragma once

#include "geometry/numbers/export.h"
#include "reflect/reflections.h"

namespace sightline::inline reflect {

// Marks the triangles. The reflections have no polygons.
[[nodiscard]] SIGHTLINE_EXPORT Reflections reflecting_triangles(const MirrorWorld& world, const Camera& camera,
                                                                LabelledMesh& labelled);

}  // namespace sightline::inline reflect
