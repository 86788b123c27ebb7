#include "geometry/cutting/validate_cuts.h"

#include <algorithm>
#include <map>

#include "geometry/cutting/common_lines.h"
#include "geometry/cutting/facet_cutter.h"
#include "geometry/mesh/facet_plane.h"
#include "geometry/mesh/validate_facets.h"
#include "geometry/numbers/id_names.h"

namespace sightline::inline geometry {
namespace {

using Messages = std::vector<std::string>;

class CutsCheck {
 public:
  CutsCheck(const CutMesh& mesh, Messages& messages) : mesh_(mesh), cuts_(mesh.cuts), messages_(messages) {}

  void run() {
    check_sizes();
    if (!messages_.empty()) return;
    check_points();
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) check_piece(FacetId(f));
    for (std::size_t w = 0; w < cuts_.uncut_facets.size(); ++w) check_border(UncutFacetId(w));
    for (const auto& [a, b] : cuts_.crossing) {
      check_apart(a, b);
      check_apart(b, a);
    }
  }

 private:
  void require(bool holds, const std::string& what) {
    if (!holds) messages_.push_back(what);
  }

  void check_sizes() {
    require(cuts_.points.size() <= mesh_.vertices.size(), "cuts: more points than vertices");
    require(cuts_.uncut_facet_of.size() == mesh_.facet_count(), "cuts: not one uncut facet per facet");
    require(cuts_.first_facet.size() == cuts_.uncut_facets.size() + 1,
            "cuts: not one first facet per uncut facet and one more");
    require(cuts_.input_edge.size() == mesh_.edges.size(), "cuts: not one edge of the input per mesh edge");
  }

  void check_points() {
    std::vector<ExactPosition> sorted = cuts_.points;
    const auto before = [](const ExactPosition& a, const ExactPosition& b) { return lexicographic_order(a, b) < 0; };
    std::ranges::sort(sorted, before);
    require(std::ranges::adjacent_find(sorted) == sorted.end(), "cuts: two points are one");
    for (std::size_t i = 0; i < cuts_.points.size(); ++i) {
      const VertexId v(mesh_.input_vertex_count() + i);
      const ExactPosition& p = cuts_.points[i];
      require(p.w > 0 && gcd(gcd(p.xyz.x(), p.xyz.y()), gcd(p.xyz.z(), p.w)) == 1, name(v) + " is not in lowest terms");
      require(mesh_.position(v) == p.rounded(), name(v) + " is not its exact position rounded");
    }
  }

  [[nodiscard]] ExactPlane plane_of(FacetId f) const {
    const auto [a, b, c] = plane_corners(mesh_, f);
    return plane_through(exact_position(mesh_, a), exact_position(mesh_, b), exact_position(mesh_, c));
  }

  // A piece has to be planar, convex, and turned as the uncut facet is: seen along an axis, it turns to one side only and
  // runs up once.
  void check_piece(FacetId f) {
    const CutPolygon polygon = facet_polygon(mesh_, f);
    const ExactPlane plane = plane_of(f);
    const int axis = plane.normal.x() != 0 ? 0 : plane.normal.y() != 0 ? 1 : 2;
    const Sign turn = sign_of(plane.normal[axis]);
    bool planar = true;
    bool convex = true;
    int rises = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ExactPosition& a = polygon[i].position;
      const ExactPosition& b = polygon[(i + 1) % polygon.size()].position;
      const ExactPosition& c = polygon[(i + 2) % polygon.size()].position;
      planar = planar && plane.side(a) == 0;
      convex = convex && orientation_without(axis, a, b, c) * turn >= 0;
      rises += lexicographic_order(a, b) > 0 && lexicographic_order(b, c) < 0 ? 1 : 0;
    }
    require(planar, name(f) + " is not in the plane of its uncut facet");
    require(convex && rises == 1, name(f) + " is not convex");
  }

  // Each edge of an uncut facet's pieces has two of them, in opposite directions, or is on a side of it.
  void check_border(UncutFacetId w) {
    std::map<MeshEdgeId, std::vector<int>> directions;
    for (std::size_t f = cuts_.first_facet[w.index()].index(); f < cuts_.first_facet[w.index() + 1].index(); ++f) {
      const auto corners = mesh_.corners(FacetId(f));
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const MeshEdgeId e = mesh_.edges_of(FacetId(f))[i];
        directions[e].push_back(mesh_.weld[corners[i].index()] == mesh_.edges[e.index()][0] ? 1 : -1);
      }
    }
    for (const auto& [edge, of_pieces] : directions) {
      const bool inside = of_pieces.size() == 2 && of_pieces[0] + of_pieces[1] == 0;
      const bool on_side = of_pieces.size() == 1 && is_on_side(w, edge);
      require(inside || on_side, name(w) + " has pieces that do not fit along mesh edge " + std::to_string(edge.value));
    }
  }

  [[nodiscard]] bool is_on_side(UncutFacetId w, MeshEdgeId edge) const {
    const auto corners = cuts_.uncut_facets[w.index()];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto on_line = [&](VertexId v) {
        return collinear(mesh_, corners[i], corners[(i + 1) % corners.size()], v);
      };
      if (on_line(mesh_.edges[edge.index()][0]) && on_line(mesh_.edges[edge.index()][1])) return true;
    }
    return false;
  }

  // No piece of a may be passed through by b.
  void check_apart(UncutFacetId a, UncutFacetId b) {
    const ExactPlane plane = plane_of(cuts_.first_facet[b.index()]);
    const CutPolygon other = polygon_of(b);
    const Chord chord = meet(other, plane_of(cuts_.first_facet[a.index()]));
    for (std::size_t f = cuts_.first_facet[a.index()].index(); f < cuts_.first_facet[a.index() + 1].index(); ++f) {
      require(!passes_through(plane, chord, facet_polygon(mesh_, FacetId(f))),
              name(FacetId(f)) + " is passed through by " + name(b));
    }
  }

  [[nodiscard]] CutPolygon polygon_of(UncutFacetId w) const {
    CutPolygon polygon;
    for (const VertexId v : cuts_.uncut_facets[w.index()])
      polygon.push_back({exact_position(mesh_, v), v, MeshEdgeId{}});
    return polygon;
  }

  const CutMesh& mesh_;
  const FacetCuts& cuts_;
  Messages& messages_;
};

// An uncut mesh as the Mesh it was.
Mesh as_given(const PolygonMesh& mesh) {
  Mesh given;
  static_cast<PolygonMesh&>(given) = mesh;
  return given;
}

void check_snapped(const CutMesh& mesh, Messages& messages) {
  if (mesh.snapped_to.empty()) return;
  if (mesh.snapped_to.size() != mesh.uncut_facet_count()) {
    messages.emplace_back("snapped: not one plane per uncut facet");
    return;
  }
  for (std::size_t u = 0; u < mesh.snapped_to.size(); ++u) {
    const UncutFacetId plane = mesh.snapped_to[u];
    if (plane.index() >= mesh.snapped_to.size() || mesh.is_snapped(plane))
      messages.push_back(name(UncutFacetId(u)) + " is snapped to a plane that is no facet's own");
  }
}

}  // namespace

void check_cuts(const CutMesh& mesh, std::vector<std::string>& messages) { CutsCheck(mesh, messages).run(); }

// What is said of positions holds of the mesh before it was cut; of the pieces it holds exactly, and of the numbering for
// both.
std::vector<std::string> validate(const CutMesh& mesh) {
  Messages messages = mesh.is_cut() ? check_arrays(mesh) : validate(as_given(mesh));
  if (messages.empty()) check_snapped(mesh, messages);
  if (!mesh.is_cut()) return messages;
  if (messages.empty()) messages = validate(without_cuts(mesh));
  if (messages.empty()) check_facet_edges(mesh, messages);
  if (messages.empty()) check_numbering(mesh, messages);
  if (messages.empty()) check_cuts(mesh, messages);
  return messages;
}

}  // namespace sightline::inline geometry
