// Facets that pass through each other, cut along their common lines.
//
// In:  a mesh and its contacts (interpenetration.h).
// Out: a CutMesh with the same faces whose facets no longer pass through each other, so that any two have one order in depth
//      wherever they overlap. Where nothing crosses it is the mesh as given. What it was cut from is in CutMesh::cuts.
// Holds: faces and the input's vertices keep their numbers; the vertices that cutting makes follow them. What cuts a
//      mesh edge cuts it for all facets on it; what cuts a common line cuts it for both facets that meet there: no
//      vertex lies inside an edge that runs along the line it was made on.
//      The result does not depend on the order of faces, but for numbering.
// Complexity: O(c log c) for c crossing pairs and the pieces they make, in integers of any size.
// Source: docs/design.md, section 4, "faces that interpenetrate".
// Rejected: an edge at whose crossing two facets swap in the node list. Its ends are rounded, and where they miss the
// facets' rounded borders by less than the grid, the order around them has no consistent answer. Pieces have closed
// borders wherever their corners are rounded to, so the sweep needs to know nothing of common lines.
#pragma once

#include "geometry/cutting/interpenetration.h"
#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/export.h"

namespace sightline::inline geometry {

[[nodiscard]] SIGHTLINE_EXPORT CutMesh cut_along_common_lines(Mesh mesh, const MeshContacts& contacts);

// Returns the mesh as it was before the cut.
[[nodiscard]] SIGHTLINE_EXPORT Mesh without_cuts(const CutMesh& mesh);

}  // namespace sightline::inline geometry
