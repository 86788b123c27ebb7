// Ray casting: a ray through each pixel's centre, and the first polygon that it meets.
//
// In:  the flat scene and the resolution. Out: an item buffer.
// Source: Koucký 2014, section 2.2 (a point is visible if a ray can travel to it without colliding with another
//      object); Fang 1993, section 2.3 (a viewing ray through every pixel: the nearest surface that it intersects is
//      visible); slides 001, generic image precision algorithm ("the object closest to the viewer that is pierced by
//      the projector through the pixel").
// Precision: image. Cost: O(n p) for n polygons and p pixels; a ray is tested against a polygon only where it passes
// through the polygon's screen extent.
// Cannot: see anything that no ray meets; decide in double which of two polygons is in front where both have the same
// depth at a centre: coplanar ones that overlap, or that touch there. Where the computed depths are equal, the lower
// face index is in front.
// Holds: what it says does not depend on other pixels, so this is what the other peers at image precision are held to.
#pragma once

#include "peers/scene/peer.h"

namespace sightline::peers {

[[nodiscard]] Peer ray_casting();

}  // namespace sightline::peers
