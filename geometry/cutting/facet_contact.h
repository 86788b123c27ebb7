// How two facets meet, apart from the vertices and edges that they share.
//
// In:  two facets with welded corners.
// Out:
//   - crossing: their interiors meet, and their planes differ: each passes through the other along their common line;
//   - touching: they meet, outside the vertices and edges they share, without crossing so;
//   - none: they meet in what they share at most.
// Exact. What is shared is known by its id, without arithmetic.
// Complexity: O(k) sides of planes where these decide, as they do for most neighbours; else O(k^2) orientations, for k
// corners.
//
// How: where the planes differ, the facets meet in a segment of the planes' common line, each end of which is a corner
// of one facet or the place where an edge passes through the plane. Where they coincide, they meet in a convex polygon,
// each vertex of which is a corner of one facet or a crossing of two edges. So looking at corners and edges is enough.
// Facets cross where each has corners strictly on both sides of the other's plane, and the two intervals in which they
// meet the planes' common line overlap in more than a point (after Devillers and Guigue 2002, for convex polygons).
#pragma once

#include "geometry/mesh/convex_facet.h"

namespace sightline::inline geometry {

enum class Contact { none, touching, crossing };

[[nodiscard]] Contact contact_of(const ConvexFacet& a, const ConvexFacet& b);

}  // namespace sightline::inline geometry
