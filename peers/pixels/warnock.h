// Warnock's area subdivision: a rectangle of the image that is not simple is cut into four.
//
// In:  the flat scene and the resolution. Out: an item buffer.
// Source: slides 001, "Warnockov algoritem" (both pseudo-codes, "A Fast Way to Restore ilist"); slides 003,
//      "Warnock-ov postupak".
// Names there: dlist (polygons known to be disjoint from the rectangle), slist (known to enclose it: the surround
//      list), ilist (all others: they may intersect it or lie in it); shold and dhold, where slist and dlist began
//      before the rectangle's polygons were distributed. The lists are linked through the polygons, so that those in
//      front of shold and dhold go back to ilist without a test: what is disjoint from a rectangle, or encloses it, is
//      so for all its parts, and its parts begin with what is left.
// Precision: image. Cost: O(n log p) to find the places for n small polygons in p pixels; then a visit to each
// rectangle on the way to the pixels that an edge passes through, whether that edge is seen or not, times the polygons
// there.
// Cannot: see what lies between the centres of pixels; of coplanar polygons that overlap, double arithmetic need not
// find the depths equal. Where it does, the lower face index is in front.
// Departures: where no edge passes through a rectangle, its middle tells whether it is enclosed (slides: one of its
// vertices, which may touch). The first pseudo-code ends with pixels, the second leaves them out; both are here.
#pragma once

#include "peers/scene/peer.h"

namespace sightline::peers {

[[nodiscard]] Peer warnock();

}  // namespace sightline::peers
