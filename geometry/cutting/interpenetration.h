// Where a mesh meets itself apart from its shared vertices and edges.
//
// In:  a mesh.
// Out: the pairs of facets that cross (each passes through the other's interior along their planes' common line), and
//      those that touch (they meet, outside shared vertices and edges, without crossing: T-junctions, coplanar overlap,
//      tips). Exact on the input's coordinates; shared vertices and edges are recognised by index (welded), without
//      arithmetic.
// Complexity: O(n log n) plus the pairs whose bounding boxes overlap (a hierarchy of boxes, median split).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/numbers/export.h"

namespace sightline::inline geometry {

struct MeshContacts {
  std::vector<std::array<FacetId, 2>> crossing;  // smaller id first; sorted
  std::vector<std::array<FacetId, 2>> touching;  // pairs that meet without crossing; sorted
};

[[nodiscard]] SIGHTLINE_EXPORT MeshContacts find_contacts(const PolygonMesh& mesh);

}  // namespace sightline::inline geometry
