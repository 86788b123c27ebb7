// Ears are clipped off polygons that may touch themselves; this is the inner step of face_triangulation.h, which says
// what holds.
//
// An ear is a corner b with its neighbours a and c where the boundary turns left and no other part of it enters the
// triangle abc or touches the diagonal between a and c. Clipping it replaces the edges ab and bc by that diagonal.
//
// Few corners can be in the way. Seen from b, the farthest part of the boundary inside abc is a corner with the
// polygon's inside before it, so it does not turn left. Therefore only corners that do not turn left are looked at. One
// inside abc is in the way. One on the triangle's boundary (the polygon touches itself) is in the way only if it is on
// the open diagonal, or one of its edges leads into the triangle.
#pragma once

#include <optional>
#include <vector>

#include "geometry/faces/face_triangulation.h"

namespace sightline::inline geometry {

// Returns triangles, counter-clockwise in the view, whose boundaries add up to that of the polygon; nullopt if at some
// point no ear is left. Triangles may overlap where the polygon goes round a place more than once.
[[nodiscard]] std::optional<std::vector<Triangle>> clip_ears(const PolygonView& polygon, const FaceView& view);

}  // namespace sightline::inline geometry
