#include "reconstruct/labelling/facet_border.h"

#include <algorithm>
#include <map>

namespace sightline::inline reconstruct {
namespace {

// Returns the points of an edge in the direction in which the facet runs through it.
std::vector<EdgePoint> along(const CutMesh& mesh, const EdgePoints& edge_points, MeshEdgeId edge, VertexId from) {
  const auto on_edge = edge_points.on(edge);
  std::vector<EdgePoint> result(on_edge.begin(), on_edge.end());
  if (mesh.weld[from.index()] != mesh.edges[edge.index()][0]) std::reverse(result.begin(), result.end());
  return result;
}

template <class Point, class VertexOf>
void drop_repeated(std::vector<Point>& border, VertexOf vertex_of) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const Point& next = border[i + 1 == border.size() ? 0 : i + 1];
    if (vertex_of(border[i]) != vertex_of(next)) kept.push_back(border[i]);
  }
  border = std::move(kept);
}

}  // namespace

std::vector<std::uint32_t> straight_sides(const CutMesh& mesh, std::span<const VertexId> corners) {
  const std::size_t n = corners.size();
  std::vector<std::uint32_t> side(n);
  for (std::uint32_t i = 0; i < n; ++i) side[i] = i;
  if (n == 3) return side;
  const auto straight_at = [&](std::size_t i) {
    return collinear(mesh, corners[i == 0 ? n - 1 : i - 1], corners[i], corners[i + 1 == n ? 0 : i + 1]);
  };
  for (std::size_t i = 1; i < n; ++i) side[i] = straight_at(i) ? side[i - 1] : side[i];
  if (!straight_at(0)) return side;
  const std::uint32_t last = side.back();
  std::replace(side.begin(), side.end(), last, side.front());
  return side;
}

std::vector<BorderPoint> facet_border(const CutMesh& mesh, const EdgePoints& edge_points, FacetId facet) {
  const auto corners = mesh.corners(facet);
  const auto edges = mesh.edges_of(facet);
  const auto sides = straight_sides(mesh, mesh.corners(facet));
  std::vector<BorderPoint> border;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    border.push_back({corners[i], sides[i]});
    for (const EdgePoint& p : along(mesh, edge_points, edges[i], corners[i])) border.push_back({p.vertex, sides[i]});
  }
  return border;
}

namespace {

// This is an edge of a piece, in the piece's direction.
struct PieceEdge {
  VertexId from;
  MeshEdgeId edge;
  bool forward = false;  // along the mesh edge
};

// Returns the edges on the border of an uncut facet: inside it each edge has two pieces.
std::vector<PieceEdge> border_edges(const CutMesh& mesh, UncutFacetId uncut) {
  std::vector<PieceEdge> edges;
  for (std::size_t f = mesh.first_piece(uncut).index(); f < mesh.end_piece(uncut).index(); ++f) {
    const auto corners = mesh.corners(FacetId(f));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const MeshEdgeId e = mesh.edges_of(FacetId(f))[i];
      edges.push_back({corners[i], e, mesh.weld[corners[i].index()] == mesh.edges[e.index()][0]});
    }
  }
  std::ranges::sort(edges, {}, &PieceEdge::edge);
  std::vector<PieceEdge> border;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool inside =
        (i > 0 && edges[i - 1].edge == edges[i].edge) || (i + 1 < edges.size() && edges[i + 1].edge == edges[i].edge);
    if (!inside) border.push_back(edges[i]);
  }
  return border;
}

// Returns the edges in their order around the uncut facet.
std::vector<PieceEdge> linked(const CutMesh& mesh, const std::vector<PieceEdge>& border, VertexId start) {
  std::map<VertexId, PieceEdge> leaving;
  for (const PieceEdge& e : border) leaving[mesh.weld[e.from.index()]] = e;
  std::vector<PieceEdge> result;
  for (VertexId v = mesh.weld[start.index()]; result.size() < border.size();) {
    result.push_back(leaving.at(v));
    v = mesh.edges[result.back().edge.index()][result.back().forward ? 1 : 0];
  }
  return result;
}

}  // namespace

std::vector<BorderPoint> uncut_border(const CutMesh& mesh, const EdgePoints& edge_points, UncutFacetId uncut) {
  const auto edges = linked(mesh, border_edges(mesh, uncut), mesh.cuts.uncut_facets[uncut.index()].front());
  std::vector<VertexId> corners;
  for (const PieceEdge& e : edges) corners.push_back(e.from);
  const auto sides = straight_sides(mesh, corners);
  std::vector<BorderPoint> border;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    border.push_back({corners[i], sides[i]});
    for (const EdgePoint& p : along(mesh, edge_points, edges[i].edge, corners[i])) {
      border.push_back({p.vertex, sides[i]});
    }
  }
  return border;
}

VertexId corner_vertex(const LabelSources& from, const ClippedCorner& corner, InnerVertices& inner) {
  if (corner.vertex.valid()) return corner.vertex;
  const MadeCorner& made = from.scene.made(corner);
  if (made.on_edge.valid()) return from.edge_points.vertex(made.on_edge, corner.point);
  return inner.vertex_at(corner.point, made.position);
}

std::vector<PointId> splits_between(const LabelSources& from, FacetId facet, std::size_t i,
                                    std::span<const EdgeSplit> splits_of_view_border) {
  const auto polygon = from.scene.polygon(facet);
  const PointId first = polygon[i].point;
  const PointId last = polygon[i + 1 == polygon.size() ? 0 : i + 1].point;
  std::vector<PointId> result;
  for (const EdgeSplit& split : splits_of_view_border) {
    const SceneEdge& edge = from.scene.edge(split.edge);
    if (split.facet == facet && edge.top == std::min(first, last) && edge.bottom == std::max(first, last)) {
      result.push_back(split.point);
    }
  }
  std::sort(result.begin(), result.end(), [&](PointId a, PointId b) {
    return first < last ? from.points.sweeps_before(a, b) : from.points.sweeps_before(b, a);
  });
  return result;
}

std::vector<ViewBorderPoint> view_border(const LabelSources& from, FacetId facet,
                                         std::span<const EdgeSplit> splits_of_view_border, InnerVertices& inner) {
  const CutMesh& mesh = from.mesh;
  const auto polygon = from.scene.polygon(facet);
  const auto corners = mesh.corners(facet);
  const auto edges = mesh.edges_of(facet);
  const auto sides = straight_sides(mesh, mesh.corners(facet));
  std::vector<ViewBorderPoint> border;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ClippedCorner& corner = polygon[i];
    const ClippedCorner& next = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const auto own_side = static_cast<std::uint32_t>(corners.size() + i);
    ViewBorderPoint point{{corner_vertex(from, corner, inner), own_side}, corner.point};
    if (!corner.edge_after.valid()) {
      border.push_back(point);
      for (const PointId p : splits_between(from, facet, i, splits_of_view_border)) {
        border.push_back({{inner.vertex_at(p, std::nullopt), own_side}, p});
      }
      continue;
    }
    const auto place =
        static_cast<std::size_t>(std::find(edges.begin(), edges.end(), corner.edge_after) - edges.begin());
    point.border.side = sides[place];
    border.push_back(point);
    for (const EdgePoint& p : along(mesh, from.edge_points, corner.edge_after, corners[place])) {
      if (p.vertex == point.border.vertex || p.vertex == corner_vertex(from, next, inner)) continue;
      border.push_back({{p.vertex, sides[place]}, p.point});
    }
  }
  drop_repeated(border, [](const ViewBorderPoint& p) { return p.border.vertex; });
  return border;
}

namespace {

// Returns the corners of the rounded polygon at which the facet itself turns. Rounding may bend a straight side, within
// the grid.
std::vector<ImagePoint> turning_points(const ProjectedScene& scene, FacetId facet) {
  const CutMesh& mesh = scene.mesh();
  const auto polygon = scene.polygon(facet);
  const auto edges = mesh.edges_of(facet);
  const std::vector<std::uint32_t> sides = straight_sides(mesh, mesh.corners(facet));
  const auto side_after = [&](const ClippedCorner& corner) -> std::optional<std::uint32_t> {
    if (!corner.edge_after.valid()) return std::nullopt;
    return sides[static_cast<std::size_t>(std::ranges::find(edges, corner.edge_after) - edges.begin())];
  };
  std::vector<ImagePoint> points;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto side = side_after(polygon[i]);
    if (side && side == side_after(polygon[i == 0 ? polygon.size() - 1 : i - 1])) continue;
    const ImagePoint& point = scene.point(polygon[i].point);
    if (points.empty() || points.back() != point) points.push_back(point);
  }
  while (points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

}  // namespace

bool is_proper(const ProjectedScene& scene, FacetId facet) {
  if (scene.is_unrounded()) return scene.status[facet.index()] == FacetStatus::in_view;
  const CutMesh& mesh = scene.mesh();
  const Sign turn = scene.facing[facet.index()] == FacetFacing::back ? -1 : 1;
  const auto polygon = scene.polygon(facet);
  if (polygon.size() == 3 && mesh.corners(facet).size() == 3) {
    return orientation(scene.point(polygon[0].point), scene.point(polygon[1].point), scene.point(polygon[2].point)) ==
           turn;
  }
  const std::vector<ImagePoint> p = turning_points(scene, facet);
  bool turns = false;
  int descents = 0;  // how often the border begins to run down the sweep order: once around a convex polygon
  for (std::size_t i = 0; i < p.size() && p.size() > 2; ++i) {
    const ImagePoint& b = p[(i + 1) % p.size()];
    const ImagePoint& c = p[(i + 2) % p.size()];
    const Sign o = orientation(p[i], b, c) * turn;
    if (o < 0) return false;
    turns = turns || o > 0;
    descents += sweeps_before(b, p[i]) && sweeps_before(b, c) ? 1 : 0;
  }
  return turns && descents == 1;
}

}  // namespace sightline::inline reconstruct
