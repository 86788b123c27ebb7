// A mesh over a complete rectangular grid: whether it is one, and which vertex is where.
//
// In:  a mesh, the axis (0: x, 1: y, 2: z) that is to be its height.
// Out: the grid of the other two coordinates; nothing where the mesh is no single-valued function over one: every
//      pair of values has exactly one (welded) vertex, and each cell is covered exactly once, by one facet or by two
//      triangles.
// Complexity: O(n log n). Errors: none.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/mesh/cut_mesh.h"

namespace sightline::peers {

struct HeightGrid {
  int height_axis = 1;
  std::array<int, 2> ground_axes{};
  std::array<std::vector<double>, 2> values;  // per ground axis, ascending
  std::vector<VertexId> vertices;             // by the first ground axis' value, then by the second's

  [[nodiscard]] VertexId at(std::size_t first, std::size_t second) const {
    return vertices[first * values[1].size() + second];
  }
};

[[nodiscard]] std::optional<HeightGrid> height_grid(const CutMesh& mesh, int height_axis);

}  // namespace sightline::peers
