// The mesh of the pieces into which facets were cut.
//
// In:  a mesh, and per facet its pieces (facet_cutter.h), or none where it stays whole.
// Out: the mesh of these facets. Of the cuts (CutMesh::cuts) all is known but who crosses whom.
// Holds: faces and the input's vertices keep their numbers; the vertices that cutting made follow them. What cuts a
//      mesh edge cuts it for all facets on it, and what cuts a line that was cut along for all pieces on it.
// Complexity: O(n log n), and that of the pieces, in integers of any size.
#pragma once

#include <vector>

#include "geometry/cutting/facet_cutter.h"

namespace sightline::inline geometry {

[[nodiscard]] CutMesh mesh_of_pieces(const PolygonMesh& mesh, const std::vector<std::vector<CutPolygon>>& pieces);

}  // namespace sightline::inline geometry
