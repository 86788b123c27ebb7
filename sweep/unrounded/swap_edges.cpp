#include "sweep/unrounded/swap_edges.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline sweep {

EdgeId SwapEdges::between(FacetId f, FacetId g) {
  const auto [first, second] = std::minmax({surface_of(scene_.mesh(), f), surface_of(scene_.mesh(), g)});
  const auto [known, is_new] = known_.try_emplace(std::uint64_t{first.value} << 32 | second.value);
  if (is_new) {
    known->second = EdgeId(scene_.edge_count() + edges_.size());
    edges_.push_back(made(first, second));
  }
  return known->second;
}

Sign SwapEdges::nearer_side(EdgeId e, FacetId f) const {
  const SwapEdge& edge = edges_[e.index() - scene_.edge_count()];
  return surface_of(scene_.mesh(), f) == edge.surfaces[0] ? edge.first_nearer : -edge.first_nearer;
}

SwapEdge SwapEdges::made(FacetId first, FacetId second) {
  const auto& of_first = nearness(first);
  const auto& of_second = nearness(second);
  std::optional<SwapEdge> edge;
  if (of_first && of_second) edge = swap_edge_tiers::filtered(*of_first, *of_second);
  if (!edge) edge = swap_edge_tiers::exact(exact_nearness_.of(first), exact_nearness_.of(second));
  edge->surfaces = {first, second};
  return *edge;
}

const std::optional<Nearness<Bounded>>& SwapEdges::nearness(FacetId surface) {
  const auto [known, is_new] = nearness_.try_emplace(surface.value);
  if (is_new) known->second = bounded_nearness(scene_, surface);
  return known->second;
}

}  // namespace sightline::inline sweep
