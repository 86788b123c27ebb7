// The generic object-precision algorithm: every polygon against every other one.
//
//     for (each object in the world) {
//       determine those parts of the object whose view is unobstructed by other parts of it or any other object
//       draw those parts in the appropriate color
//     }
//
// Source: slides 001 ("Generic object precision algorithm", extents and minmax testing) and 004 ("Object vs. Image
//      Precision"). Their objects are our polygons. The slides do not say how the parts are determined: here the one
//      in front is taken away from the one behind, as Weiler and Atherton do, with convex polygons only.
// Precision: object; computed in double. Every cut's points are rounded, and parts below resolution (convex_ring.h) are
//      left out.
// Cost: (n - 1) + (n - 2) + ... + 1 pairs, each compared once; of those whose extents overlap one polygon is cut.
// Cannot: tell the order of planes that are closer to each other than a rounding error of their depth. Coplanar
//      polygons are told exactly, by the rule of sightline.
// Holds: what it says is seen of all polygons together does not overlap, up to rounding.
#pragma once

#include "peers/scene/peer.h"

namespace sightline::peers {

[[nodiscard]] Peer every_pair();

}  // namespace sightline::peers
