#include "cli/pages/face_borders.h"

#include <algorithm>
#include <span>

namespace sightline::cli {

namespace {

using Ends = std::array<VertexId, 2>;  // the smaller one first

Ends edge_of(const LabelledTriangle& triangle, std::size_t i) {
  const VertexId a = triangle.corners[i];
  const VertexId b = triangle.corners[(i + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

std::vector<Ends> sorted_edges(std::span<const LabelledTriangle> face) {
  std::vector<Ends> edges;
  for (const LabelledTriangle& triangle : face) {
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(edge_of(triangle, i));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void append_borders(std::span<const LabelledTriangle> face, std::vector<std::uint8_t>& borders) {
  const std::vector<Ends> edges = sorted_edges(face);
  for (const LabelledTriangle& triangle : face) {
    unsigned border = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [first, last] = std::equal_range(edges.begin(), edges.end(), edge_of(triangle, i));
      if (last - first == 1) border |= 1U << i;
    }
    borders.push_back(static_cast<std::uint8_t>(border));
  }
}

}  // namespace

std::vector<std::uint8_t> face_borders(const LabelledMesh& labelled) {
  const std::span<const LabelledTriangle> triangles(labelled.triangles);
  std::vector<std::uint8_t> borders;
  borders.reserve(triangles.size());
  for (std::size_t begin = 0; begin < triangles.size();) {
    std::size_t end = begin + 1;
    while (end < triangles.size() && triangles[end].face == triangles[begin].face) ++end;
    append_borders(triangles.subspan(begin, end - begin), borders);
    begin = end;
  }
  return borders;
}

}  // namespace sightline::cli
