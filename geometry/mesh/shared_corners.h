// Corners that a face's border has on one way only, put in on the other.
//
// In:  the outlines of faces, without spikes; positions welded.
// Out: where a corner of a face lies strictly inside one of the face's own edges, exactly, that edge has the corner
//      too, in this face and in every other face with the edge. A border may lie on itself so: along a slit to a hole
//      whose ways there and back have different corners, or where a corner touches an edge. Then both ways consist of
//      the same mesh edges, and stay on each other whatever rounding does to their points.
// Complexity: O(k^2) for an outline of k corners that is not a planar convex polygon.
#pragma once

#include <span>

#include "geometry/mesh/mesh_topology.h"

namespace sightline::inline geometry {

void share_corners(PolygonList& outlines, std::span<const Point3> vertices, const Welding& welding);

}  // namespace sightline::inline geometry
