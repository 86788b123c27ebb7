// Whether a surface is closed: then only the fronts of its facets need be looked at.
//
// In:  a mesh, its facets as they were before they were cut.
// Out: a box around it, where each edge is run through as often in one direction as in the other; nothing elsewhere.
// Holds: along a way the winding number of a closed surface rises by one where the way meets a facet's front, and falls by one where it
//      meets its back. It is 0 outside the box. So a way that ends there, and begins where the number is at most 0, meets a front if
//      it meets anything. It is at most 0 at what an eye outside the box sees: on the way there it fell at backs that are not
//      in the eye's way, if there are any. (Where a near plane cuts the surface open, the eye sees places inside.)
// Complexity: O(n log n) for n edges.
#pragma once

#include <optional>

#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/cut_mesh.h"

namespace sightline::inline reflect {

[[nodiscard]] std::optional<Box> box_of_closed(const CutMesh& mesh);

}  // namespace sightline::inline reflect
