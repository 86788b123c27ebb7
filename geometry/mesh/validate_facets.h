// This is the part of validate(mesh) that looks at shapes: are the facets convex and planar, and do they cover their
// faces?
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace sightline::inline geometry {

// Appends a message, with ids, for each facet or face that does not hold what mesh.h says. Precondition: arrays have
// the right sizes, ids are in range, and facets are numbered by face.
void check_facets(const Mesh& mesh, std::vector<std::string>& messages);

}  // namespace sightline::inline geometry
