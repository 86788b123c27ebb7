// Where a mesh meets itself apart from its shared vertices and edges.
//
// In:  a mesh.
// Out: the pairs of facets that cross (an edge of one passes strictly through the other's interior), and how many
//      pairs touch (they meet, outside shared vertices and edges, without crossing so: T-junctions, coplanar overlap,
//      tips). Exact on the input's coordinates; shared vertices and edges are recognised by index (welded), without
//      arithmetic.
// Complexity: O(n log n) plus the pairs whose bounding boxes overlap (a hierarchy of boxes, median split).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace sightline {

struct MeshContacts {
  std::vector<std::array<FacetId, 2>> crossing;  // smaller id first; sorted
  std::vector<std::array<FacetId, 2>> touching;  // pairs that meet without crossing; sorted
};

[[nodiscard]] MeshContacts find_contacts(const Mesh& mesh);

}  // namespace sightline
