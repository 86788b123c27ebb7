// The swap edges of a scene, as they are asked for.
//
// In:  an unrounded scene; pairs of facets, as somebody asks for them.
// Out: per pair of surfaces a line, directed downwards like an edge of the scene, and which of both is nearer on its right.
// A pair may be asked for whose facets overlap beside and behind the camera, too.
// Method: how near a plane is to the eye (1 / W of a pinhole camera, minus the depth otherwise) is a linear form of the
//      homogeneous place (x, y, w), found from three corners. Where two forms are equal, the planes meet; so the line is the
//      difference of the forms, and its sign says who is nearer.
// Complexity: O(1) per pair, in integers of any size, once.
// Source: docs/unrounded.md.
#pragma once

#include <array>
#include <map>
#include <unordered_map>
#include <vector>

#include "sweep/segments/swap_edge.h"

namespace sightline::inline sweep {

class SwapEdges {
 public:
  explicit SwapEdges(const ProjectedScene& scene) : scene_(scene) {}

  // By their ids, which follow those of the scene's edges.
  [[nodiscard]] const std::vector<SwapEdge>& all() const { return edges_; }

  // Returns the edge of two facets' surfaces. Precondition: these pass through each other.
  [[nodiscard]] EdgeId between(FacetId f, FacetId g);

  // Returns +1 where the facet, of one of the edge's surfaces, is the nearer one on the right of the edge, -1 where on its
  // left.
  [[nodiscard]] Sign nearer_side(EdgeId e, FacetId f) const;

 private:
  // (a x + b y + c w) / k says how near the plane is; k > 0.
  struct Nearness {
    BigInteger a, b, c, k;
  };
  [[nodiscard]] const Nearness& nearness(FacetId surface);
  [[nodiscard]] SwapEdge made(FacetId f, FacetId g);

  const ProjectedScene& scene_;
  std::vector<SwapEdge> edges_;
  std::unordered_map<std::uint64_t, EdgeId> known_;  // by both surfaces; only looked up
  std::map<FacetId, Nearness> nearness_;
};

}  // namespace sightline::inline sweep
