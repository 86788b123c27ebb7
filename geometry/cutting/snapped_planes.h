// Faces that all but lie on each other, made coplanar in the order of depth.
//
// A window in its wall is coplanar by design, and by the last digits of its corners it is not. What was found to lie on each other
// (coincidence.h) gets one plane: that of the largest surface among those that hang together. Nothing else is moved: outlines and
// normals stay, so that edges still meet; but of what lies on each other depths are equal, and the rule of coplanar facets says
// what is seen.
//
// In:  a mesh that was not cut, the distance.
// Out: CutMesh::snapped_to; empty where no two surfaces are to have one plane that do not have one anyway.
// Holds: a surface (facet_plane.h) is in one plane, with all of its facets. All corners of a surface are at most the distance from
//      the plane it is snapped to; where more hang together than lie so near to one plane, what is left of them has another one,
//      or its own. A plane that surfaces are snapped to is that of its own surface.
// Approximate: distances are computed in double. Everything behind the door takes the planes as exact.
// Complexity: that of coincident_facets, and O(k^2) for k surfaces that hang together.
// Rejected: to order pairs, each by itself, by the rule of coplanar facets: that is no order where a third facet passes between
// two. To move corners: there are no doubles on most planes. To cut away what is hidden: slivers, where edges all but meet, too.
#pragma once

#include <vector>

#include "geometry/mesh/cut_mesh.h"

namespace sightline::inline geometry {

[[nodiscard]] std::vector<UncutFacetId> snapped_planes(const CutMesh& mesh, double distance);

}  // namespace sightline::inline geometry
