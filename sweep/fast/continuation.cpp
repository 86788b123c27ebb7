#include "sweep/fast/continuation.h"

#include <algorithm>

#include "geometry/numbers/parallel.h"

namespace sightline::inline sweep {
namespace {

// Returns +1 where the eye sees the facet's polygon counter-clockwise.
Sign turn_of(const ProjectedScene& scene, FacetId f) { return scene.facing[f.index()] == FacetFacing::back ? -1 : 1; }

// Returns whether the rounded polygon is convex, without straight or turned corners, and runs around once: then the
// triangles of its fan have area, too.
bool is_proper(const ProjectedScene& scene, FacetId f) {
  if (scene.is_unrounded()) return true;
  const auto corners = scene.polygon(f);
  const Sign turn = turn_of(scene, f);
  const auto at = [&](std::size_t i) { return scene.point(corners[i % corners.size()].point); };
  if (corners.size() == 3) return orientation(at(0), at(1), at(2)) == turn;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (orientation(at(i), at(i + 1), at(i + 2)) != turn) return false;
    if (i > 1 && orientation(at(0), at(i - 1), at(i)) != turn) return false;
  }
  return true;
}

std::vector<std::uint8_t> proper_facets(const ProjectedScene& scene) {
  std::vector<std::uint8_t> proper(scene.status.size(), 0);
  parallel_for_each(proper.size(), [&](std::size_t f) {
    if (scene.status[f] == FacetStatus::in_view && is_proper(scene, FacetId(f))) proper[f] = 1;
  });
  return proper;
}

// Ids are invalid where the surface does not simply continue. A side's winding has the facet's turn where the facet
// lies right of the edge.
Neighbours neighbours_across(const ProjectedScene& scene, EdgeId e, const std::vector<std::uint8_t>& proper) {
  const auto sides = scene.sides_of(e);
  if (sides.size() != 2 || !sides[0].mesh_edge.valid() || sides[0].mesh_edge != sides[1].mesh_edge) return {};
  Neighbours found;
  for (const EdgeSide& side : sides) {
    if (proper[side.facet.index()] == 0) return {};
    (side.winding == turn_of(scene, side.facet) ? found.right : found.left) = side.facet;
  }
  return found.left.valid() && found.right.valid() ? found : Neighbours{};
}

}  // namespace

Continuation::Continuation(const ProjectedScene& scene) : proper_(proper_facets(scene)) {
  neighbours_.resize(scene.edge_count());
  parallel_for_each(scene.edge_count(),
                    [&](std::size_t e) { neighbours_[e] = neighbours_across(scene, EdgeId(e), proper_); });
  find_edges(scene);
}

void Continuation::find_edges(const ProjectedScene& scene) {
  edges_.resize(scene.polygon_corners.size());
  parallel_for_each(scene.edge_count(), [&](std::size_t e) {
    const SceneEdge& edge = scene.edges[e];
    for (const EdgeSide& side : scene.sides_of(EdgeId(e))) {
      const PointId from = side.winding > 0 ? edge.top : edge.bottom;
      const auto first = scene.polygon_begin[side.facet.index()];
      const auto polygon = scene.polygon(side.facet);
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const PointId next = polygon[i + 1 == polygon.size() ? 0 : i + 1].point;
        if (polygon[i].point == from && (next == edge.top || next == edge.bottom)) edges_[first + i] = EdgeId(e);
      }
    }
  });
}

}  // namespace sightline::inline sweep
