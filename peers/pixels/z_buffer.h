// Z-buffer: polygons in any order, and per pixel the depth of what was painted there last.
//
// In:  the flat scene and the resolution. Out: an item buffer (the slides' frame buffer, with faces for colours).
// Source: slides 001, "Z-buffer algorithm"; slides 004, "Depth-Buffer Method".
// Names there: z_buffer (the depth per pixel), framebuffer, pz (the polygon's depth at the pixel).
// Precision: image. Cost: O(n + pixels that the polygons cover, hidden ones included); a depth per pixel of memory.
// Cannot: see what lies between the centres of pixels; decide by a finite precision of depth between polygons that are
// nearer to each other than that. Here a depth is a double, where the slides' is a number of 32 bits; where computed
// depths are equal, the lower face index is in front.
// Departures: depth grows away from the eye, so nearer is less (slides 001: greater). The depth of each pixel is
// computed from the plane, where slides 004 go along the scan line by z' = z - A / C: it costs a multiplication more
// and does not add up rounding errors along the line, so that what is wrong here is wrong because of the pixels alone.
#pragma once

#include "peers/scene/peer.h"

namespace sightline::peers {

[[nodiscard]] Peer z_buffer();

}  // namespace sightline::peers
