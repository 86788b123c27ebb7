#include "reflect/world/closed_surface.h"

#include <algorithm>
#include <vector>

#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {
namespace {

struct RunEdge {
  VertexId first;
  VertexId second;
  int times = 0;  // from the first to the second, less those back
};

std::vector<RunEdge> edges_of(const CutMesh& mesh) {
  std::vector<RunEdge> edges;
  for (std::size_t f = 0; f < mesh.uncut_facet_count(); ++f) {
    const auto corners = mesh.uncut_corners(UncutFacetId(f));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const VertexId p = mesh.weld[corners[i].index()];
      const VertexId q = mesh.weld[corners[(i + 1) % corners.size()].index()];
      edges.push_back({std::min(p, q), std::max(p, q), p < q ? 1 : -1});
    }
  }
  return edges;
}

bool are_balanced(std::vector<RunEdge> edges) {
  std::ranges::sort(edges, [](const RunEdge& a, const RunEdge& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  for (auto e = edges.begin(); e != edges.end();) {
    int times = 0;
    const RunEdge edge = *e;
    for (; e != edges.end() && e->first == edge.first && e->second == edge.second; ++e) times += e->times;
    if (times != 0) return false;
  }
  return true;
}

}  // namespace

std::optional<Box> box_of_closed(const CutMesh& mesh) {
  if (mesh.uncut_facet_count() == 0 || !are_balanced(edges_of(mesh))) return std::nullopt;
  Box box = box_of(mesh, mesh.uncut_corners(UncutFacetId(0)));
  for (std::size_t f = 1; f < mesh.uncut_facet_count(); ++f)
    box = hull(box, box_of(mesh, mesh.uncut_corners(UncutFacetId(f))));
  return box;
}

}  // namespace sightline::inline reflect
