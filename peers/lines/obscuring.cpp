#include "peers/lines/obscuring.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"

namespace sightline::peers {
namespace {

Point2 place(const Corner& c) { return {c.x, c.y}; }

const Corner& after(const FlatPolygon& polygon, std::size_t i) {
  return polygon.corners[i + 1 == polygon.corners.size() ? 0 : i + 1];
}

const Corner& before(const FlatPolygon& polygon, std::size_t i) {
  return polygon.corners[i == 0 ? polygon.corners.size() - 1 : i - 1];
}

// Returns the side of the line from a to b on which p lies, which is on the scene's line.
Sign side_at(const Point2& a, const Point2& b, const SceneLine& line, const Point2& p) {
  const Sign from = side_of_moved_point(a, b, place(line.from.place));
  const Sign to = side_of_moved_point(a, b, place(line.to.place));
  if (from == to) return to;
  const Sign side = orient2d(a, b, p);
  return side != 0 ? side : to;
}

// Returns whether p, which is on the line, is above the height of c.
bool is_above(const SceneLine& line, const Point2& p, const Point2& c) {
  if (p.y != c.y) return p.y > c.y;
  return line.to.place.y >= line.from.place.y;
}

// Outside, a ray from p to the left meets as many edges that run downwards as upwards. Polygons are convex up to the
// grid only, where corners are straight, so it is not enough to be left of each edge.
bool covers(const FlatPolygon& polygon, const SceneLine& line, const Point2& p) {
  int winding = 0;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Point2 a = place(polygon.corners[i]);
    const Point2 b = place(after(polygon, i));
    const bool is_downwards = is_above(line, p, b) && !is_above(line, p, a);
    const bool is_upwards = is_above(line, p, a) && !is_above(line, p, b);
    if (is_downwards && side_at(a, b, line, p) > 0) ++winding;
    if (is_upwards && side_at(a, b, line, p) < 0) --winding;
  }
  return winding != 0;
}

bool has_edge(const CutMesh& mesh, const FlatPolygon& polygon, MeshEdgeId edge) {
  const auto edges = mesh.edges_of(polygon.facet);
  return std::find(edges.begin(), edges.end(), edge) != edges.end();
}

// Returns +1 beyond the polygon's plane, seen from the eye, -1 before it, 0 in it.
Sign beyond(const CutMesh& mesh, const FlatPolygon& polygon, VertexId vertex) {
  const Sign side = side_of_plane(mesh, polygon.facet, {mesh.position(vertex), 1});
  return polygon.is_front ? -side : side;
}

bool is_before(const CutMesh& mesh, const FlatPolygon& polygon, const SceneLine& line, const Corner& p) {
  const auto [first, second] = mesh.edges[line.edge.index()];
  const Sign low = std::min(beyond(mesh, polygon, first), beyond(mesh, polygon, second));
  const Sign high = std::max(beyond(mesh, polygon, first), beyond(mesh, polygon, second));
  if (low < 0 && high > 0) return polygon.plane.at(p.x, p.y) < p.depth;
  return high > 0;
}

}  // namespace

Obscuring::Obscuring(const FlatScene& scene) : scene_(scene) {
  for (const FlatPolygon& polygon : scene.polygons) {
    const auto clipped = scene.projected->polygon(polygon.facet);
    for (std::size_t i = 0; i < clipped.size(); ++i) {
      const VertexId vertex = clipped[i].vertex;
      const std::size_t corner = polygon.is_front ? i : clipped.size() - 1 - i;
      if (vertex.valid()) corners_.push_back({scene.mesh->weld[vertex.index()], &polygon, corner});
    }
  }
  std::stable_sort(corners_.begin(), corners_.end(),
                   [](const PolygonCorner& a, const PolygonCorner& b) { return a.vertex < b.vertex; });
}

int Obscuring::count_at(const SceneLine& line, double t) const {
  const Corner p = line.at(t);
  int count = 0;
  for (const FlatPolygon& polygon : scene_.polygons) {
    if (!covers(polygon, line, place(p)) || has_edge(*scene_.mesh, polygon, line.edge)) continue;
    if (is_before(*scene_.mesh, polygon, line, p)) ++count;
  }
  return count;
}

int Obscuring::count_beside(const SceneLine& line, const LineEnd& beginning) const {
  const bool is_from = beginning.vertex == line.from.vertex;
  const Point2 end = place(is_from ? line.to.place : line.from.place);
  const VertexId far_vertex = scene_.mesh->edges[line.edge.index()][is_from ? 1 : 0];
  const auto by_vertex = [](const PolygonCorner& c, VertexId v) { return c.vertex < v; };
  auto at = std::lower_bound(corners_.begin(), corners_.end(), beginning.vertex, by_vertex);
  int count = 0;
  for (; at != corners_.end() && at->vertex == beginning.vertex; ++at) {
    const FlatPolygon& polygon = *at->polygon;
    const Point2 corner = place(polygon.corners[at->corner]);
    if (has_edge(*scene_.mesh, polygon, line.edge)) continue;
    const bool is_between = side_of_moved_point(corner, place(after(polygon, at->corner)), end) > 0 &&
                            side_of_moved_point(place(before(polygon, at->corner)), corner, end) > 0;
    if (is_between && beyond(*scene_.mesh, polygon, far_vertex) > 0) ++count;
  }
  return count;
}

}  // namespace sightline::peers
