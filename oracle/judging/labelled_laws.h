// What must hold between a surface and its labelled refinement, computed here from nothing but positions and corners.
#pragma once

#include "oracle/judging/judge.h"

namespace sightline::lattice {

// The first vertices are the input's, bit for bit.
[[nodiscard]] Complaints input_vertices_kept(const PolygonMesh& mesh, const LabelledMesh& labelled);

// Per face: its triangles together have the area of its facets, relative 1e-12, or within what rounding their corners
// to doubles can change: each corner moves by at most half a unit in the last place of its coordinates, and the area
// by that times the boundary's length.
[[nodiscard]] Complaints areas_kept(const PolygonMesh& mesh, const LabelledMesh& labelled);

// Whether every directed edge, by position, is matched by as many in the opposite direction.
[[nodiscard]] bool is_closed(const PolygonMesh& mesh);
[[nodiscard]] bool is_closed(const LabelledMesh& labelled);

// Per face: the image area of its triangles that are seen, computed in double, against the area of its visible
// polygons.
[[nodiscard]] Complaints seen_areas_agree(const View& view, double tolerance);

}  // namespace sightline::lattice
