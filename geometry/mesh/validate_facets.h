// This is the part of validate(mesh) that looks at shapes: are the facets convex and planar, and do they cover their
// faces?
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace sightline::inline geometry {

// Appends a message, with ids, for each facet or face that does not hold what mesh.h says. Precondition: arrays have
// the right sizes, ids are in range, and facets are numbered by face.
void check_facets(const PolygonMesh& mesh, std::vector<std::string>& messages);

// Sizes and ranges: what the other checks need in order to look at anything.
[[nodiscard]] std::vector<std::string> check_arrays(const PolygonMesh& mesh);

// Whether the edges after the corners of each facet join these corners, and every mesh edge is one of them.
void check_facet_edges(const PolygonMesh& mesh, std::vector<std::string>& messages);

// Whether facets are numbered by face.
void check_numbering(const PolygonMesh& mesh, std::vector<std::string>& messages);

}  // namespace sightline::inline geometry
