// Where the surface simply continues across an edge of the scene, as the eye sees it.
//
// In:  a projected scene.
// Out: per edge the one facet on its left and the one on its right, where the edge is nothing but the line at which the
//      one passes into the other; every other edge is a contour edge: a silhouette, a border, a fold, an edge of more
//      than two facets, one where different edges of the mesh fall on each other, one of a facet that rounding has
//      turned over.
// Holds: a facet with an edge that is no contour edge is proper: it is in view, its rounded polygon is convex, not
//      degenerate, and turns as the facet does. Without rounding all facets in view are. So the facets that
//      continue each other cover what they cover of the image once.
// Complexity: O(n).
// Source: docs/design.md, section 8, idea 1.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

struct Neighbours {
  FacetId left;
  FacetId right;
};

class Continuation {
 public:
  explicit Continuation(const ProjectedScene& scene);

  [[nodiscard]] bool is_contour(EdgeId e) const { return !neighbours_[e.index()].left.valid(); }
  [[nodiscard]] bool is_proper(FacetId f) const { return proper_[f.index()] != 0; }
  // The ids are invalid at a contour edge.
  [[nodiscard]] const Neighbours& across(EdgeId e) const { return neighbours_[e.index()]; }

  // Returns, per corner of the facet's polygon, the edge to the next corner; it is invalid where both are one point.
  [[nodiscard]] std::span<const EdgeId> edges_of(const ProjectedScene& scene, FacetId f) const {
    const auto first = scene.polygon_begin[f.index()];
    return std::span(edges_).subspan(first, scene.polygon_begin[f.index() + 1] - first);
  }

 private:
  void find_edges(const ProjectedScene& scene);

  std::vector<std::uint8_t> proper_;    // per facet
  std::vector<Neighbours> neighbours_;  // per edge
  std::vector<EdgeId> edges_;           // parallel to the scene's polygon corners
};

}  // namespace sightline::inline sweep
