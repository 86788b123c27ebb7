// Watkins' scan line algorithm: along each row of pixels, spans in which what is visible cannot change.
//
// In:  the flat scene and the resolution. Out: an item buffer.
// Source: slides 003, "Watkins-ov postupak".
// Names there: ET, the edge table (an entry: x of the end with the smaller y, y_max of the other one, delta_x from scan
//      line to scan line, ID of the polygon); PT, the polygon table (ID, plane equation, shading info, in-out flag);
//      AET, the active edge table: the edges that the scan line crosses, by x; segment, where the scan line's plane
//      cuts a polygon; sample span, where the number of segments is constant and none crosses another.
// Precision: image, and along x that of the numbers. Cost: O(e log e) for e edges, and per scan line its active edges
// and, for each sample span, the segments in it; pixels are only filled in.
// Cannot: see what lies between the centres of pixels; of coplanar polygons that overlap, double arithmetic need not
// find the depths equal. Where it does, the lower face index is in front. An edge's x is carried along by additions: a
// centre that an edge passes within some 1e-12 of may fall on its other side.
// Departures: scan lines go from bottom to top, through the centres of pixels, as the tables want it. The slides test a
// sample span only if the number of segments or the order of their ends changed since the scan line before; here each
// is tested, since a depth that was decided wrongly near a vertex would be kept all along the polygons else. Where
// segments cross is found by testing a span's first and last centre: one segment that is in front at both is in front
// between.
#pragma once

#include "peers/scene/peer.h"

namespace sightline::peers {

[[nodiscard]] Peer watkins();

}  // namespace sightline::peers
