#include "peers/lines/height_grid.h"

#include <algorithm>
#include <cstdint>

namespace sightline::peers {
namespace {

std::vector<VertexId> used_vertices(const CutMesh& mesh) {
  std::vector<VertexId> used;
  for (const VertexId v : mesh.facets.corners) used.push_back(mesh.weld[v.index()]);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

std::vector<double> values_along(const CutMesh& mesh, const std::vector<VertexId>& vertices, int axis) {
  std::vector<double> values;
  for (const VertexId v : vertices) values.push_back(mesh.position(v)[axis]);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

using GridPlace = std::array<std::size_t, 2>;

GridPlace place_of(const HeightGrid& grid, const Point3& p) {
  GridPlace place{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& values = grid.values[i];
    const auto at = std::lower_bound(values.begin(), values.end(), p[grid.ground_axes[i]]);
    place[i] = static_cast<std::size_t>(at - values.begin());
  }
  return place;
}

// Returns false where the grid has a place without a vertex, or with two.
bool set_vertices(HeightGrid& grid, const CutMesh& mesh, const std::vector<VertexId>& vertices) {
  if (vertices.size() != grid.values[0].size() * grid.values[1].size()) return false;
  grid.vertices.resize(vertices.size());
  for (const VertexId v : vertices) {
    const auto [first, second] = place_of(grid, mesh.position(v));
    VertexId& at = grid.vertices[first * grid.values[1].size() + second];
    if (at.valid()) return false;
    at = v;
  }
  return true;
}

// A facet that covers some of a cell has a bit for each of the cell's corners that it has, counted around the cell.
using CornerBits = std::uint8_t;
constexpr CornerBits all_corners = 0b1111;

struct CellPart {
  std::size_t cell = 0;
  CornerBits corners = 0;
  friend auto operator<=>(const CellPart&, const CellPart&) = default;
};

CornerBits bit_of(bool is_far_first, bool is_far_second) {
  if (is_far_first) return is_far_second ? 0b0100 : 0b0010;
  return is_far_second ? 0b1000 : 0b0001;
}

// Returns nothing where the facet reaches over more than one cell.
std::optional<CellPart> part_of(const HeightGrid& grid, const CutMesh& mesh, FacetId facet) {
  GridPlace least{grid.values[0].size(), grid.values[1].size()};
  for (const VertexId v : mesh.corners(facet)) {
    const GridPlace place = place_of(grid, mesh.position(v));
    for (std::size_t i = 0; i < 2; ++i) least[i] = std::min(least[i], place[i]);
  }
  CellPart part{least[0] * grid.values[1].size() + least[1], 0};
  for (const VertexId v : mesh.corners(facet)) {
    const auto [first, second] = place_of(grid, mesh.position(v));
    if (first > least[0] + 1 || second > least[1] + 1) return std::nullopt;
    part.corners = static_cast<CornerBits>(part.corners | bit_of(first > least[0], second > least[1]));
  }
  return part;
}

// Two triangles cover a cell where they leave out opposite corners.
bool are_halves(CornerBits a, CornerBits b) {
  const auto left_out = (all_corners & ~a) | (all_corners & ~b);
  return left_out == 0b0101 || left_out == 0b1010;
}

bool covers_cells_once(const HeightGrid& grid, const CutMesh& mesh) {
  std::vector<CellPart> parts;
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    const auto part = part_of(grid, mesh, FacetId(f));
    if (!part) return false;
    parts.push_back(*part);
  }
  std::sort(parts.begin(), parts.end());
  std::size_t cells = 0;
  for (std::size_t i = 0; i < parts.size(); ++cells) {
    const bool is_whole = parts[i].corners == all_corners;
    const std::size_t next = i + (is_whole ? 1 : 2);
    if (next > parts.size() || (next < parts.size() && parts[next].cell == parts[i].cell)) return false;
    if (!is_whole && (parts[i + 1].cell != parts[i].cell || !are_halves(parts[i].corners, parts[i + 1].corners))) {
      return false;
    }
    i = next;
  }
  return cells == (grid.values[0].size() - 1) * (grid.values[1].size() - 1);
}

}  // namespace

std::optional<HeightGrid> height_grid(const CutMesh& mesh, int height_axis) {
  HeightGrid grid;
  grid.height_axis = height_axis;
  grid.ground_axes = {(height_axis + 1) % 3, (height_axis + 2) % 3};
  const std::vector<VertexId> vertices = used_vertices(mesh);
  if (vertices.empty()) return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i) grid.values[i] = values_along(mesh, vertices, grid.ground_axes[i]);
  if (!set_vertices(grid, mesh, vertices) || !covers_cells_once(grid, mesh)) return std::nullopt;
  return grid;
}

}  // namespace sightline::peers
