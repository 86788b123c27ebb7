#include "oracle/scenes/crossing_kinds.h"

#include <algorithm>
#include <map>
#include <set>

namespace sightline::lattice {
namespace {

using UncutFacets = std::set<UncutFacetId>;
using InputEdge = std::array<VertexId, 2>;

// These are the facets that meet in a point that cutting made, and along an edge that it made.
struct Meetings {
  std::map<VertexId, UncutFacets> at_point;
  std::map<VertexId, std::map<InputEdge, UncutFacets>> edges_at_point;
  std::map<MeshEdgeId, UncutFacets> along;
};

Meetings meetings(const CutMesh& mesh) {
  Meetings result;
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    const UncutFacetId uncut = mesh.cuts.uncut_facet_of[f];
    const auto corners = mesh.corners(FacetId(f));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const MeshEdgeId edge = mesh.edges_of(FacetId(f))[i];
      const InputEdge& input = mesh.cuts.input_edge[edge.index()];
      if (!input[0].valid()) result.along[edge].insert(uncut);
      for (const VertexId v : {corners[i], corners[(i + 1) % corners.size()]}) {
        if (v.index() < mesh.input_vertex_count()) continue;
        result.at_point[v].insert(uncut);
        if (input[0].valid()) result.edges_at_point[v][input].insert(uncut);
      }
    }
  }
  return result;
}

bool cross(const CutMesh& mesh, UncutFacetId a, UncutFacetId b) {
  return std::ranges::binary_search(mesh.cuts.crossing, std::array{std::min(a, b), std::max(a, b)});
}

bool three_cross(const CutMesh& mesh, const UncutFacets& facets) {
  for (const UncutFacetId a : facets) {
    for (const UncutFacetId b : facets) {
      if (a < b && cross(mesh, a, b) &&
          std::ranges::any_of(facets, [&](UncutFacetId c) { return b < c && cross(mesh, a, c) && cross(mesh, b, c); }))
        return true;
    }
  }
  return false;
}

bool edges_of_two_that_cross(const CutMesh& mesh, const std::map<InputEdge, UncutFacets>& edges) {
  const auto cross_each_other = [&](const auto& e, const auto& f) {
    return std::ranges::any_of(e.second, [&](UncutFacetId a) {
      return std::ranges::any_of(f.second, [&](UncutFacetId b) { return a != b && cross(mesh, a, b); });
    });
  };
  return std::ranges::any_of(edges, [&](const auto& e) {
    return std::ranges::any_of(edges, [&](const auto& f) { return e.first < f.first && cross_each_other(e, f); });
  });
}

bool is_of_several(const CutMesh& mesh, UncutFacetId uncut) {
  const FaceId face = mesh.facet_face[mesh.cuts.first_facet[uncut.index()].index()];
  const UncutFacetId first = mesh.cuts.uncut_facet_of[mesh.face_facet[face.index()].index()];
  const UncutFacetId last = mesh.cuts.uncut_facet_of[mesh.face_facet[face.index() + 1].index() - 1];
  return first != last;
}

}  // namespace

CrossingKinds crossing_kinds(const CutMesh& cut) {
  if (!cut.is_cut()) return {};
  const Meetings found = meetings(cut);
  const auto of = [](const auto& entry) -> const auto& { return entry.second; };
  CrossingKinds kinds;
  kinds.three_in_a_point = std::ranges::any_of(
      found.at_point, [&](const UncutFacets& facets) { return three_cross(cut, facets); }, of);
  kinds.three_on_a_line = std::ranges::any_of(
      found.along, [](const UncutFacets& facets) { return facets.size() > 2; }, of);
  kinds.end_on_both_edges = std::ranges::any_of(
      found.edges_at_point, [&](const auto& edges) { return edges_of_two_that_cross(cut, edges); }, of);
  kinds.concave = std::ranges::any_of(
      cut.cuts.crossing, [&](const auto& pair) { return is_of_several(cut, pair[0]) || is_of_several(cut, pair[1]); });
  return kinds;
}

}  // namespace sightline::lattice
