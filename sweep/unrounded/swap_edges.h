// The swap edges of a scene, as they are asked for.
//
// In:  an unrounded scene; pairs of facets, as somebody asks for them.
// Out: per pair of surfaces a line, directed downwards like an edge of the scene, and which of both is nearer on its right.
// A pair may be asked for whose facets overlap beside and behind the camera, too.
// Method: the difference of two forms (swap_edge.h), by a filter, and exactly where that leaves something open.
// Complexity: O(1) per pair, once.
// Source: docs/unrounded.md.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "sweep/segments/swap_line.h"

namespace sightline::inline sweep {

class SwapEdges {
 public:
  explicit SwapEdges(const ProjectedScene& scene) : scene_(scene), exact_nearness_(scene) {}

  // By their ids, which follow those of the scene's edges.
  [[nodiscard]] const std::vector<SwapEdge>& all() const { return edges_; }

  // Returns the edge of two facets' surfaces. Precondition: these pass through each other.
  [[nodiscard]] EdgeId between(FacetId f, FacetId g);

  // Returns +1 where the facet, of one of the edge's surfaces, is the nearer one on the right of the edge, -1 where on its
  // left.
  [[nodiscard]] Sign nearer_side(EdgeId e, FacetId f) const;

 private:
  [[nodiscard]] const std::optional<Nearness<Bounded>>& nearness(FacetId surface);
  [[nodiscard]] SwapEdge made(FacetId first, FacetId second);

  const ProjectedScene& scene_;
  std::vector<SwapEdge> edges_;
  std::unordered_map<std::uint64_t, EdgeId> known_;                               // by both surfaces; only looked up
  std::unordered_map<std::uint32_t, std::optional<Nearness<Bounded>>> nearness_;  // per surface; only looked up
  ExactNearness exact_nearness_;
};

}  // namespace sightline::inline sweep
