#include "sweep/plain/sweep_input.h"

namespace sightline::inline sweep {
namespace {

// Groups edges by one of their ends, in the order of edges within a group.
template <class EndOf>
void group(const ProjectedScene& scene, EndOf end_of, std::vector<EdgeId>& edges, std::vector<std::uint32_t>& begin) {
  begin.assign(scene.points.size() + 1, 0);
  for (std::size_t e = 0; e < scene.edge_count(); ++e) ++begin[end_of(scene.edges[e]).index() + 1];
  for (std::size_t p = 1; p < begin.size(); ++p) begin[p] += begin[p - 1];
  edges.resize(scene.edge_count());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t e = 0; e < scene.edge_count(); ++e) edges[next[end_of(scene.edges[e]).index()]++] = EdgeId(e);
}

}  // namespace

SweepInput::SweepInput(const ProjectedScene& scene) {
  group(
      scene, [](const SceneEdge& e) { return e.top; }, by_top_, top_begin_);
  group(
      scene, [](const SceneEdge& e) { return e.bottom; }, by_bottom_, bottom_begin_);
  find_several_vertices(scene);
}

void SweepInput::find_several_vertices(const ProjectedScene& scene) {
  const CutMesh& mesh = scene.mesh();
  several_vertices_.assign(scene.points.size(), 0);
  std::vector<VertexId> seen(scene.points.size());
  for (const ClippedCorner& corner : scene.polygon_corners) {
    if (!corner.vertex.valid()) continue;
    const VertexId vertex = mesh.weld[corner.vertex.index()];
    VertexId& first = seen[corner.point.index()];
    if (!first.valid()) first = vertex;
    if (first != vertex) several_vertices_[corner.point.index()] = 1;
  }
}

}  // namespace sightline::inline sweep
