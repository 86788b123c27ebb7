// The floating horizon: the visible parts of the polylines of a height field.
//
// In:  a flat scene that is a height field, seen so that its polylines have an order from front to back
//      (height_field.h says which do; others are refused). `resolution`: how many columns the window has.
// Out: the parts of its polylines that are seen.
// Two arrays with one entry per column, YMAX and YMIN, hold the highest and lowest places of all that is nearer.
// Polylines come from front to back; in a column, one is seen where it is not between YMIN and YMAX. Then it is
// entered itself.
// Precision: image. What is seen is decided at the columns' centres, for all of a column; there it is exact up to
// rounding. So parts end up to half a column off, and what hides or shows between two centres only is missed.
// Cost: O(l c) for l edges and c columns that each one spans.
// Cannot: anything but height fields. Errors: RefusedScene.
// Departure: between two polylines the edges that join them are entered, too. The surface hides with its triangles,
// not only with the polylines: a ridge across two of them may be higher in a column than either.
// Source: slides 004, "Horizon Line Algorithm".
#pragma once

#include "peers/scene/peer.h"

namespace sightline::peers {

[[nodiscard]] Peer floating_horizon();

}  // namespace sightline::peers
