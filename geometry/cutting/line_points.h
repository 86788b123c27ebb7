// The points that lie on the lines along which facets were cut: mesh edges and common lines.
//
// In:  the edges of pieces, each on a mesh edge or on a common line.
// Out: per line its points in order, so that every piece can take those inside its own edges as corners.
// A common line is known by its exact Plücker coordinates: pieces of different facets that lie on one line of space
// share its points, whichever planes they were cut by.
// Complexity: O(m log m) for m edges.
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"

namespace sightline::inline geometry {

class LinePoints {
 public:
  // The mesh has all vertices, those that cutting made included.
  explicit LinePoints(const CutMesh& mesh) : mesh_(mesh) {}

  // `edge` is invalid for an edge on a common line.
  void add(MeshEdgeId edge, VertexId from, VertexId to);

  // This is called once, when all are added. `rank` is, per vertex, the lexicographic order of exact positions.
  void sort(std::span<const std::uint32_t> rank);

  // Returns the points strictly between two points of the line, from the first to the second.
  [[nodiscard]] std::vector<VertexId> between(MeshEdgeId edge, VertexId from, VertexId to,
                                              std::span<const std::uint32_t> rank) const;

 private:
  using Plucker = std::array<BigInteger, 6>;
  [[nodiscard]] Plucker line_through(VertexId from, VertexId to) const;
  [[nodiscard]] const std::vector<VertexId>* find(MeshEdgeId edge, VertexId from, VertexId to) const;

  const CutMesh& mesh_;
  std::map<MeshEdgeId, std::vector<VertexId>> on_mesh_edge_;
  std::map<Plucker, std::vector<VertexId>> on_common_line_;
};

}  // namespace sightline::inline geometry
