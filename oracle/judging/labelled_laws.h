// These laws must hold between a surface and its labelled refinement; they are computed here from nothing but positions
// and corners.
#pragma once

#include "oracle/judging/judge.h"

namespace sightline::lattice {

// The first vertices are the input's, bit for bit.
[[nodiscard]] Complaints input_vertices_kept(const PolygonMesh& mesh, const LabelledMesh& labelled);

// The triangles of a face together have the area of its facets, relative 1e-12, or within what rounding their corners
// to doubles can change: each corner moves by at most half a unit in the last place of its coordinates, and the area by
// that times the boundary's length.
[[nodiscard]] Complaints areas_kept(const PolygonMesh& mesh, const LabelledMesh& labelled);

// Returns whether every directed edge, by position, is matched by as many in the opposite direction.
[[nodiscard]] bool is_closed(const PolygonMesh& mesh);
[[nodiscard]] bool is_closed(const LabelledMesh& labelled);

// The image area of a face's triangles that are seen, computed in double, is held against the area of its visible
// polygons.
[[nodiscard]] Complaints seen_areas_agree(const View& view, double tolerance);

}  // namespace sightline::lattice
