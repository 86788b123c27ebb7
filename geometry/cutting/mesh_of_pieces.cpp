#include "geometry/cutting/mesh_of_pieces.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "geometry/cutting/line_points.h"
#include "geometry/faces/face_shape.h"
#include "geometry/mesh/mesh_topology.h"

namespace sightline::inline geometry {
namespace {

struct LexicographicallyBefore {
  bool operator()(const ExactPosition& a, const ExactPosition& b) const { return lexicographic_order(a, b) < 0; }
};

// This numbers the points that cutting makes. A point that is a vertex of the input is that vertex.
class CutVertices {
 public:
  CutVertices(const PolygonMesh& mesh, const Welding& welding) : mesh_(mesh), welding_(welding) {}

  VertexId number(const ExactPosition& p) {
    const auto place = numbers_.find(p);
    if (place != numbers_.end()) return place->second;
    const VertexId of_input = find_in_input(p);
    const VertexId v = of_input.valid() ? of_input : VertexId(mesh_.vertices.size() + points_.size());
    if (!of_input.valid()) points_.push_back(p);
    numbers_.emplace(p, v);
    return v;
  }

  [[nodiscard]] const std::vector<ExactPosition>& points() const { return points_; }

 private:
  [[nodiscard]] VertexId find_in_input(const ExactPosition& p) const {
    const Point3 rounded = p.rounded();
    if (exact_position(rounded) != p) return VertexId{};
    const auto key = [this](VertexId v) {
      const Point3& q = mesh_.position(v);
      return std::tuple(q.x(), q.y(), q.z());
    };
    const std::tuple wanted(rounded.x(), rounded.y(), rounded.z());
    const auto found = std::ranges::lower_bound(welding_.by_rank, wanted, {}, key);
    return found != welding_.by_rank.end() && key(*found) == wanted ? *found : VertexId{};
  }

  const PolygonMesh& mesh_;
  const Welding& welding_;
  std::map<ExactPosition, VertexId, LexicographicallyBefore> numbers_;
  std::vector<ExactPosition> points_;
};

// A facet, or a piece of one, is described by the numbers of its corners.
struct NumberedPolygon {
  std::vector<VertexId> corners;
  std::vector<MeshEdgeId> edges_after;
};

// Continues the input's welding for the vertices that cutting made: ranks follow the exact positions.
Welding extended(Welding welding, const CutMesh& mesh) {
  for (std::size_t v = mesh.input_vertex_count(); v < mesh.vertices.size(); ++v) {
    welding.weld.emplace_back(v);
    welding.by_rank.emplace_back(v);
  }
  const auto order = [&](VertexId a, VertexId b) {
    const Point3& p = mesh.position(a);
    const Point3& q = mesh.position(b);
    if (std::max(a, b).index() < mesh.input_vertex_count()) return lexicographically_less(p, q);
    // Rounding keeps the order.
    if (p.x() != q.x()) return p.x() < q.x();
    return lexicographic_order(exact_position(mesh, a), exact_position(mesh, b)) < 0;
  };
  std::ranges::sort(welding.by_rank, order);
  welding.rank.resize(mesh.vertices.size());
  for (std::uint32_t r = 0; r < welding.by_rank.size(); ++r) welding.rank[welding.by_rank[r].index()] = r;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) welding.rank[v] = welding.rank[welding.weld[v].index()];
  return welding;
}

// Builds the mesh of the pieces.
class Cutting {
 public:
  Cutting(const PolygonMesh& mesh, const std::vector<std::vector<CutPolygon>>& pieces)
      : mesh_(mesh), welding_(weld_vertices(mesh.vertices)), vertices_(mesh, welding_), pieces_(mesh.facet_count()) {
    for (std::size_t f = 0; f < pieces.size(); ++f) {
      for (const CutPolygon& piece : pieces[f]) pieces_[f].push_back(numbered(piece));
    }
  }

  CutMesh build() {
    copy_what_stays();
    add_vertices();
    welding_ = extended(std::move(welding_), result_);
    LinePoints points = points_on_lines();
    points.sort(welding_.rank);
    add_facets(points);
    add_edges();
    return std::move(result_);
  }

 private:
  [[nodiscard]] NumberedPolygon numbered(const CutPolygon& piece) {
    NumberedPolygon polygon;
    for (const CutCorner& corner : piece) {
      polygon.corners.push_back(corner.vertex.valid() ? corner.vertex : vertices_.number(corner.position));
      polygon.edges_after.push_back(corner.edge_after);
    }
    return polygon;
  }

  void copy_what_stays() {
    result_.vertices = mesh_.vertices;
    result_.faces = mesh_.faces;
    result_.face_planar = mesh_.face_planar;
    result_.defects = mesh_.defects;
    result_.cuts.uncut_facets = mesh_.facets;
  }

  void add_vertices() {
    result_.cuts.points = vertices_.points();
    for (const ExactPosition& p : result_.cuts.points) result_.vertices.push_back(p.rounded());
  }

  [[nodiscard]] LinePoints points_on_lines() const {
    LinePoints points(result_);
    for (const auto& pieces : pieces_) {
      for (const NumberedPolygon& piece : pieces) {
        for (std::size_t i = 0; i < piece.corners.size(); ++i) {
          points.add(piece.edges_after[i], piece.corners[i], piece.corners[(i + 1) % piece.corners.size()]);
        }
      }
    }
    return points;
  }

  void add_edges() {
    MeshEdges edges = make_mesh_edges(result_.facets, welding_);
    result_.cuts.input_edge.resize(edges.ends.size());
    for (std::size_t i = 0; i < edges.of_corner.size(); ++i) {
      const MeshEdgeId whole = edge_of_corner_[i];
      if (whole.valid()) result_.cuts.input_edge[edges.of_corner[i].index()] = mesh_.edges[whole.index()];
    }
    result_.weld = welding_.weld;
    result_.edges = std::move(edges.ends);
    result_.facet_edges = std::move(edges.of_corner);
  }

  void add_facets(const LinePoints& points) {
    for (std::size_t face = 0; face < mesh_.face_count(); ++face) {
      result_.face_facet.emplace_back(result_.facets.size());
      for (std::size_t f = mesh_.first_facet(FaceId(face)); f < mesh_.end_facet(FaceId(face)); ++f) {
        result_.cuts.first_facet.emplace_back(result_.facets.size());
        add_uncut(FacetId(f), points);
        result_.facet_face.resize(result_.facets.size(), FaceId(face));
        result_.cuts.uncut_facet_of.resize(result_.facets.size(), UncutFacetId(f));
      }
    }
    result_.face_facet.emplace_back(result_.facets.size());
    result_.cuts.first_facet.emplace_back(result_.facets.size());
  }

  void add_uncut(FacetId f, const LinePoints& points) {
    if (pieces_[f.index()].empty()) {
      const auto corners = mesh_.corners(f);
      const auto edges = mesh_.edges_of(f);
      add_facet({{corners.begin(), corners.end()}, {edges.begin(), edges.end()}}, points);
    }
    for (const NumberedPolygon& piece : pieces_[f.index()]) add_facet(piece, points);
  }

  // The points inside the polygon's edges become corners, too.
  void add_facet(const NumberedPolygon& polygon, const LinePoints& points) {
    std::vector<VertexId> corners;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
      const VertexId from = polygon.corners[i];
      const VertexId to = polygon.corners[(i + 1) % polygon.corners.size()];
      corners.push_back(from);
      const auto inside = points.between(polygon.edges_after[i], from, to, welding_.rank);
      corners.insert(corners.end(), inside.begin(), inside.end());
      edge_of_corner_.resize(edge_of_corner_.size() + 1 + inside.size(), polygon.edges_after[i]);
    }
    result_.facets.push_back(corners);
  }

  const PolygonMesh& mesh_;
  Welding welding_;
  CutVertices vertices_;
  std::vector<std::vector<NumberedPolygon>> pieces_;  // per facet of the input; empty where it stays whole
  std::vector<MeshEdgeId> edge_of_corner_;            // parallel to the result's corners: the input's edge after it
  CutMesh result_;
};

}  // namespace

CutMesh mesh_of_pieces(const PolygonMesh& mesh, const std::vector<std::vector<CutPolygon>>& pieces) {
  return Cutting(mesh, pieces).build();
}

}  // namespace sightline::inline geometry
