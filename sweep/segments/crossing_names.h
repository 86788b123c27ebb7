// Names for the places of crossings where nothing is rounded: what has one name is at one place, without arithmetic.
//
// In:  an unrounded scene, and swap edges, whose ids follow those of the scene's edges; there may be more of them later.
// Out: per crossing a name. Two edges cross once, whichever is named first. Swap edges of coplanar surfaces are one line. A mesh
//      edge passes through a plane once, though its image crosses the swap edges of both of its facets there. And what
//      was found to be at one place has one name from then on.
// Holds: crossings with one name are at one place. Crossings with different names may be, too, until somebody says so.
// Not for several threads at once. Complexity: O(1) a crossing; a plane is found once, in integers of any size.
// Source: docs/unrounded.md. On real meshes most of what no bound decides are zeros of these kinds.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "sweep/segments/swap_line.h"

namespace sightline::inline sweep {

class CrossingNames {
 public:
  // All outlive it.
  CrossingNames(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges, ExactNearness& nearness)
      : scene_(scene), swap_edges_(swap_edges), nearness_(nearness) {}

  using Name = std::uint64_t;
  [[nodiscard]] Name of(EdgeId a, EdgeId b);

  // Crossings with these names are at one place.
  void unite(Name a, Name b) { united_[a] = b; }

 private:
  [[nodiscard]] bool is_swap_edge(EdgeId e) const { return e.index() >= scene_.edge_count(); }
  [[nodiscard]] bool has_snapped_plane(FacetId facet) const;
  [[nodiscard]] FacetId plane_of(FacetId surface);
  [[nodiscard]] std::array<FacetId, 2> planes_of(EdgeId swap);
  [[nodiscard]] EdgeId line_of(EdgeId e);
  [[nodiscard]] std::optional<Name> passage(EdgeId e, EdgeId swap);
  [[nodiscard]] Name united(Name name);

  const ProjectedScene& scene_;
  const std::vector<SwapEdge>& swap_edges_;
  ExactNearness& nearness_;
  std::unordered_map<std::uint32_t, FacetId> planes_;         // per surface, the first known one in its plane
  std::map<std::array<BigInteger, 4>, FacetId> surfaces_in_;  // per plane, in lowest terms
  std::unordered_map<Name, EdgeId> lines_;                    // per two planes, the first known swap edge of both
  std::unordered_map<Name, Name> passages_;  // per mesh edge and plane, the first name of where they meet
  std::unordered_map<Name, Name> united_;    // per name another one, if any
};

}  // namespace sightline::inline sweep
