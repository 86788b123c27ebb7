#include "geometry/cutting/common_lines.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <tuple>

#include "geometry/cutting/facet_cutter.h"
#include "geometry/cutting/line_points.h"
#include "geometry/faces/face_shape.h"
#include "geometry/mesh/facet_plane.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/numbers/mix.h"

namespace sightline::inline geometry {
namespace {

// Facets with the same corners have the same number, however they are numbered and wherever they begin: cutters come in
// an order that is as good as random, and that shuffling faces does not change.
std::uint64_t fingerprint(const Mesh& mesh, FacetId facet) {
  std::uint64_t sum = 0;
  for (const VertexId v : mesh.corners(facet)) {
    const Point3& p = mesh.position(v);
    std::uint64_t number = 0;
    for (const double coordinate : {p.x(), p.y(), p.z()})
      number = mix(number ^ std::bit_cast<std::uint64_t>(coordinate + 0.0));
    sum += number;
  }
  return sum;
}

// A facet that crosses others is kept with its plane and with those that cut it.
struct CrossedFacet {
  FacetId facet;
  ExactPlane plane;
  CutPolygon polygon;
  std::uint64_t fingerprint = 0;
  std::vector<std::pair<std::uint64_t, Cutter>> cutters;
};

std::vector<CrossedFacet> crossed_facets(const Mesh& mesh, const MeshContacts& contacts) {
  std::vector<FacetId> ids;
  for (const auto& [f, g] : contacts.crossing) ids.insert(ids.end(), {f, g});
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<CrossedFacet> facets;
  for (const FacetId f : ids) {
    const auto [a, b, c] = plane_corners(mesh, mesh.corners(f));
    facets.push_back({f,
                      plane_through(exact_position(mesh.position(a)), exact_position(mesh.position(b)),
                                    exact_position(mesh.position(c))),
                      facet_polygon(mesh, f),
                      fingerprint(mesh, f),
                      {}});
  }
  return facets;
}

// This holds the pieces of all facets that cross others; chords_ and facets_ stay where they are, since cutters point
// at them.
class CrossedFacets {
 public:
  CrossedFacets(const Mesh& mesh, const MeshContacts& contacts) : facets_(crossed_facets(mesh, contacts)) {
    chords_.reserve(contacts.crossing.size());
    for (const auto& [f, g] : contacts.crossing) add_crossing(find(f), find(g));
    for (CrossedFacet& facet : facets_) {
      std::ranges::stable_sort(facet.cutters, {}, [](const auto& entry) { return entry.first; });
    }
  }

  [[nodiscard]] std::size_t size() const { return facets_.size(); }
  [[nodiscard]] FacetId facet(std::size_t i) const { return facets_[i].facet; }

  [[nodiscard]] std::vector<CutPolygon> pieces(std::size_t i) const {
    std::vector<Cutter> cutters;
    for (const auto& [order, cutter] : facets_[i].cutters) cutters.push_back(cutter);
    return cut_facet(facets_[i].polygon, cutters);
  }

 private:
  CrossedFacet& find(FacetId f) { return *std::ranges::lower_bound(facets_, f, {}, &CrossedFacet::facet); }

  void add_crossing(CrossedFacet& f, CrossedFacet& g) {
    chords_.push_back(common_part(meet(f.polygon, g.plane), meet(g.polygon, f.plane)));
    f.cutters.push_back({g.fingerprint, {&g.plane, &chords_.back()}});
    g.cutters.push_back({f.fingerprint, {&f.plane, &chords_.back()}});
  }

  std::vector<CrossedFacet> facets_;
  std::vector<Chord> chords_;
};

struct LexicographicallyBefore {
  bool operator()(const ExactPosition& a, const ExactPosition& b) const { return lexicographic_order(a, b) < 0; }
};

// This numbers the points that cutting makes. A point that is a vertex of the input is that vertex.
class CutVertices {
 public:
  CutVertices(const Mesh& mesh, const Welding& welding) : mesh_(mesh), welding_(welding) {}

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

  const Mesh& mesh_;
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
  Cutting(const Mesh& mesh, const MeshContacts& contacts)
      : mesh_(mesh), welding_(weld_vertices(mesh.vertices)), vertices_(mesh, welding_), pieces_(mesh.facet_count()) {
    const CrossedFacets crossed(mesh, contacts);
    for (std::size_t i = 0; i < crossed.size(); ++i) {
      for (const CutPolygon& piece : crossed.pieces(i)) pieces_[crossed.facet(i).index()].push_back(numbered(piece));
    }
    for (const auto& [f, g] : contacts.crossing)
      result_.cuts.crossing.push_back({UncutFacetId(f.index()), UncutFacetId(g.index())});
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

  const Mesh& mesh_;
  Welding welding_;
  CutVertices vertices_;
  std::vector<std::vector<NumberedPolygon>> pieces_;  // per facet of the input; empty where it crosses none
  std::vector<MeshEdgeId> edge_of_corner_;            // parallel to the result's corners: the input's edge after it
  CutMesh result_;
};

}  // namespace

CutMesh cut_along_common_lines(Mesh mesh, const MeshContacts& contacts) {
  return contacts.crossing.empty() ? uncrossed(std::move(mesh)) : Cutting(mesh, contacts).build();
}

Mesh without_cuts(const CutMesh& mesh) {
  const auto end = mesh.vertices.begin() + static_cast<std::ptrdiff_t>(mesh.input_vertex_count());
  return build_mesh({mesh.vertices.begin(), end}, mesh.faces);
}

}  // namespace sightline::inline geometry
