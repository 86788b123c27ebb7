// The steps of build_mesh that look at positions and neighbours: welding, repeated faces, mesh edges.
//
// All are sorts, so that the result depends on the input's order only.
// Complexity: O(n log n).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace sightline::inline geometry {

// A welding makes equal positions one.
struct Welding {
  std::vector<VertexId> weld;       // per vertex: the first vertex with its position
  std::vector<std::uint32_t> rank;  // per vertex: how many positions are lexicographically smaller
  std::vector<VertexId> by_rank;    // per rank: the first vertex with that position
};
[[nodiscard]] Welding weld_vertices(std::span<const Point3> vertices);

// Returns, per polygon, whether an earlier one has the same corners (welded), in the same cyclic order.
// Empty polygons repeat nothing.
[[nodiscard]] std::vector<bool> find_repeated(const PolygonList& polygons, const Welding& welding);

struct MeshEdges {
  std::vector<std::array<VertexId, 2>> ends;  // in lexicographic order of their positions
  std::vector<MeshEdgeId> of_corner;          // parallel to the corners: the edge from this corner to the next
};
// Precondition: no corner has the position of the next.
[[nodiscard]] MeshEdges make_mesh_edges(const PolygonList& facets, const Welding& welding);

}  // namespace sightline::inline geometry
