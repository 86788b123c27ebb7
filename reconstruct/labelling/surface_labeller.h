// The labelled triangles of some of the surfaces: what several threads do at once.
//
// In:  what all surfaces are labelled from (LabelSources), and a range of facets.
// Out: the triangles of the surfaces that begin in the range, in their order, and the vertices that are new inside them
//      (new_vertices.h). The points on mesh edges are common to all surfaces.
// Complexity, errors: see labelled_mesh.h.
// Source: Koucky 2014, 3.8.
#pragma once

#include <vector>

#include "reconstruct/labelling/label_sources.h"
#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::inline reconstruct {

struct LabelledPart {
  std::vector<LabelledTriangle> triangles;
  std::vector<Point3> new_vertices;  // their ids follow those of LabelSources::vertices
};

[[nodiscard]] LabelledPart label_surfaces(const LabelSources& from, std::size_t begin, std::size_t end);

}  // namespace sightline::inline reconstruct
