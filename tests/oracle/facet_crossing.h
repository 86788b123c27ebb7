// Whether two facets pass through each other: they meet in a piece of a line of positive length, and each reaches
// strictly to both sides of the other's plane there. This counts crosses whose edges meet each other, which no edge
// through an interior tells. Exact, for any finite doubles.
#pragma once

#include "geometry/mesh.h"

namespace sightline::oracle {

[[nodiscard]] bool facets_cross(const Mesh& mesh, FacetId a, FacetId b);

}  // namespace sightline::oracle
