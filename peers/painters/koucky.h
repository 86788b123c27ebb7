// Koucky's hidden triangles and retriangulation.
//
// Source: Koucky 2014, sections 3.7 and 3.8 (algorithms 3.4 and 3.5), with the thesis' own names: V, T, visible,
//      partly_visible, RetriangulationPoints, T_closer.
// Precision: object; computed in double, with exact signs for "is inside" and for the Delaunay test.
// Cost: O(|V| |T|) for hidden triangles; for each partly visible triangle a pass over T and two triangulations.
// Cannot, all of it the published algorithm's own:
//   - see an occluder that hides no corner of a triangle: such a triangle is called visible, whole. So a bar across it,
//     with no vertex inside, is missed, and so is a small triangle before its middle;
//   - see through a gap: a triangle with three hidden corners is called hidden, whole;
//   - keep the borders of what hides: both Delaunay triangulations are unconstrained, so a new triangle may lie across
//     an occluder's edge, part of it visible and part hidden;
//   - know where the edges of two occluders cross inside a triangle: only its own edges are intersected with theirs;
//   - know the vertices of an occluder inside the triangle that meets none of the triangle's edges (line 6 is asked
//     inside line 4).
// Right for: scenes where every triangle that is hidden in part has a corner that is hidden and one that is seen, and
//      where no edge of the Delaunay triangulation crosses the border of what hides. None does where that border is one
//      straight line across the triangle.
// Where the text leaves a choice:
//   - a triangle is closer than a vertex where it is before it on the vertex' line of sight, and closer than a triangle
//     where it is before it in their overlap (in_front.h);
//   - a new triangle's visibility is that of its centroid. "In a way described in 3.7" would be by its corners, but
//     they lie on the occluders' edges, where being inside is a matter of rounding; if a new triangle is wholly visible
//     or wholly hidden, as the thesis says, any point inside it tells.
#pragma once

#include "peers/scene/peer.h"

namespace sightline::peers {

[[nodiscard]] Peer koucky();

}  // namespace sightline::peers
