#include "geometry/cutting/facet_cutter.h"

#include <algorithm>

namespace sightline::inline geometry {
namespace {

std::vector<Sign> sides_of(const CutPolygon& polygon, const ExactPlane& plane) {
  std::vector<Sign> sides;
  for (const CutCorner& corner : polygon) sides.push_back(plane.side(corner.position));
  return sides;
}

bool straddles(const std::vector<Sign>& sides) {
  return std::ranges::any_of(sides, [](Sign s) { return s > 0; }) &&
         std::ranges::any_of(sides, [](Sign s) { return s < 0; });
}

// Returns the part of the polygon on one side of the plane (Sutherland and Hodgman's step).
CutPolygon part_on_side(const CutPolygon& polygon, const std::vector<Sign>& sides, const ExactPlane& plane,
                        Sign wanted) {
  CutPolygon part;
  for (std::size_t u = 0; u < polygon.size(); ++u) {
    const std::size_t v = u + 1 == polygon.size() ? 0 : u + 1;
    const Sign at_u = sides[u] * wanted;
    const Sign at_v = sides[v] * wanted;
    if (at_u >= 0) part.push_back(polygon[u]);
    if (at_u == 0 && at_v < 0) part.back().edge_after = MeshEdgeId{};
    if (at_u * at_v >= 0) continue;
    const MeshEdgeId after = at_u > 0 ? MeshEdgeId{} : polygon[u].edge_after;
    part.push_back({intersection(plane, polygon[u].position, polygon[v].position), VertexId{}, after});
  }
  return part;
}

const ExactPosition& later(const ExactPosition& a, const ExactPosition& b) {
  return lexicographic_order(a, b) < 0 ? b : a;
}

const ExactPosition& earlier(const ExactPosition& a, const ExactPosition& b) {
  return lexicographic_order(a, b) < 0 ? a : b;
}

bool overlap(const Chord& a, const Chord& b) {
  return lexicographic_order(later(a.low, b.low), earlier(a.high, b.high)) < 0;
}

// The partition is a tree: a node is a piece, or what a cutter's plane has cut into two.
class Partition {
 public:
  explicit Partition(CutPolygon facet) { nodes_.push_back({nullptr, 0, 0, std::move(facet)}); }

  void insert(const Cutter& cutter) { insert_below(0, cutter); }

  [[nodiscard]] std::vector<CutPolygon> pieces() && {
    std::vector<CutPolygon> result;
    for (Node& node : nodes_) {
      if (node.plane == nullptr) result.push_back(std::move(node.piece));
    }
    return result;
  }

 private:
  struct Node {
    const ExactPlane* plane;  // null: a piece
    std::size_t front;
    std::size_t back;
    CutPolygon piece;
  };

  void insert_below(std::size_t node, const Cutter& cutter) {
    if (nodes_[node].plane == nullptr) return cut(node, cutter);
    const Sign low = nodes_[node].plane->side(cutter.chord->low);
    const Sign high = nodes_[node].plane->side(cutter.chord->high);
    if (low > 0 || high > 0) insert_below(nodes_[node].front, cutter);
    if (low < 0 || high < 0) insert_below(nodes_[node].back, cutter);
  }

  void cut(std::size_t node, const Cutter& cutter) {
    const CutPolygon piece = nodes_[node].piece;
    if (!passes_through(*cutter.plane, *cutter.chord, piece)) return;
    const std::vector<Sign> sides = sides_of(piece, *cutter.plane);
    nodes_[node] = {cutter.plane, nodes_.size(), nodes_.size() + 1, {}};
    nodes_.push_back({nullptr, 0, 0, part_on_side(piece, sides, *cutter.plane, 1)});
    nodes_.push_back({nullptr, 0, 0, part_on_side(piece, sides, *cutter.plane, -1)});
  }

  std::vector<Node> nodes_;
};

template <class Position>
CutPolygon polygon_of(const PolygonMesh& mesh, FacetId facet, Position position) {
  CutPolygon polygon;
  const auto corners = mesh.corners(facet);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    polygon.push_back({position(corners[i]), corners[i], mesh.edges_of(facet)[i]});
  }
  return polygon;
}

}  // namespace

CutPolygon facet_polygon(const Mesh& mesh, FacetId facet) {
  return polygon_of(mesh, facet, [&](VertexId v) { return exact_position(mesh.position(v)); });
}

CutPolygon facet_polygon(const CutMesh& mesh, FacetId facet) {
  return polygon_of(mesh, facet, [&](VertexId v) { return exact_position(mesh, v); });
}

CutPolygon part_in_front(const CutPolygon& polygon, const ExactPlane& plane) {
  const std::vector<Sign> sides = sides_of(polygon, plane);
  if (std::ranges::none_of(sides, [](Sign s) { return s > 0; })) return {};
  return part_on_side(polygon, sides, plane, 1);
}

Chord meet(const CutPolygon& polygon, const ExactPlane& plane) {
  const std::vector<Sign> sides = sides_of(polygon, plane);
  std::vector<ExactPosition> ends;
  for (std::size_t u = 0; u < polygon.size(); ++u) {
    const std::size_t v = u + 1 == polygon.size() ? 0 : u + 1;
    if (sides[u] == 0) ends.push_back(polygon[u].position);
    if (sides[u] * sides[v] < 0) ends.push_back(intersection(plane, polygon[u].position, polygon[v].position));
  }
  const bool in_order = lexicographic_order(ends.front(), ends.back()) < 0;
  return in_order ? Chord{ends.front(), ends.back()} : Chord{ends.back(), ends.front()};
}

Chord common_part(const Chord& a, const Chord& b) { return {later(a.low, b.low), earlier(a.high, b.high)}; }

bool passes_through(const ExactPlane& plane, const Chord& chord, const CutPolygon& polygon) {
  return straddles(sides_of(polygon, plane)) && overlap(meet(polygon, plane), chord);
}

std::vector<CutPolygon> cut_facet(CutPolygon facet, std::span<const Cutter> cutters) {
  Partition partition(std::move(facet));
  for (const Cutter& cutter : cutters) partition.insert(cutter);
  return std::move(partition).pieces();
}

}  // namespace sightline::inline geometry
