// Is a refined surface conforming: what splits a mesh edge splits it for all faces on it.
//
// In:  a labelled mesh with every id in range, sorted by face, and the mesh it refines.
// Out: messages with ids.
// Method: chains of directed edges between vertices (those of the input at one position are one). What is left of the sides
// of a face's triangles when opposite directions have cancelled is its border. Each mesh edge has one chain of segments, read off the border of the first face that shows it. Then the border of every face has to
// be the sum of the chains of its mesh edges, in their directions. So sides inside a face are matched within it, and
// a segment of a mesh edge has as many triangles as the mesh edge has facets: closed in, closed out. Nothing is assumed
// about the mesh: edges with one facet or many, in whatever directions, edges on edges, all the same. Rounding plays
// no part, with one exception: where several segments of border leave one point, the one that leads straightest on is
// followed.
// Complexity: O(n log n).
#pragma once

#include <string>
#include <vector>

#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::inline reconstruct {

void check_conformity(const LabelledMesh& labelled, const PolygonMesh& mesh, std::vector<std::string>& messages);

}  // namespace sightline::inline reconstruct
