// The node list: the facets over one span of the sweep line, and which of them is the topmost (Fang 5.3.1).
//
// Holds: no facet twice, no winding number 0. Right of a bundle = left of it, minus the facets that leave, plus those
// that enter. The topmost facet depends on the facets in the list alone, not on the way that led to them.
// The topmost facet is the one that is nearer than all others. Where facets overlap in the rounded image only,
// DepthOrder need not be transitive, and there may be none. In general, therefore: in range are the facets that are not
// deeper than all of another one; their top cycle is the smallest set of them each of which is nearer than all that are
// not in it; the topmost facet is the one with the lowest index in the top cycle. So what is behind all of the top
// cycle, or deeper than all of another facet, may be missing (covers.h).
// Departure from Fang, who keeps the list sorted by depth: here it is sorted by where the facets' depths begin, which
// takes no predicates, and the topmost one is kept. A facet that enters is compared with that one alone, and most lists
// are never asked for more.
#pragma once

#include <boost/container/small_vector.hpp>
#include <span>
#include <vector>

#include "geometry/numbers/ids.h"
#include "geometry/projection/projected_scene.h"
#include "sweep/plain/depth_order.h"

namespace sightline::inline sweep {

struct Node {
  FacetId facet;
  std::int32_t winding = 0;
};

class NodeList {
 public:
  // The facet is invalid where no facet is over the span.
  [[nodiscard]] FacetId topmost() const { return topmost_; }
  [[nodiscard]] bool is_topmost_nearest() const { return is_topmost_nearest_; }
  // Returns true where the topmost facet passes through another one of the list: that may take its place. It may still say so
  // when that one has left.
  [[nodiscard]] bool may_swap() const { return may_swap_; }
  [[nodiscard]] std::span<const Node> nodes() const { return {nodes_.data(), nodes_.size()}; }
  // Returns the top cycle of the facets in range; it is the topmost facet alone where that is nearer than all others.
  [[nodiscard]] std::vector<FacetId> top_cycle(DepthOrder& depth) const;

  // Crosses edges with these sides, all of one bundle, from left to right. This takes O(d + s log s) for d facets in
  // the list and s sides, and one comparison of depths for each facet that enters. Where the topmost facet changes,
  // also two for each facet whose depths begin before all of it; where there is no nearest one, one for each pair of
  // facets in range.
  void cross(std::span<const EdgeSide> sides, DepthOrder& depth);

  // Crosses the line along which the topmost facet and another one of the list change places.
  void swap_topmost(FacetId by) { topmost_ = by; }
  // Finds the topmost facet anew, where some may have changed places.
  void find_topmost(DepthOrder& depth);

  // Returns whether both hold the same facets with the same winding numbers. This is O(1): it compares a fingerprint
  // that differs for different contents with all but certainty.
  [[nodiscard]] bool same_contents(const NodeList& other) const {
    return nodes_.size() == other.nodes_.size() && fingerprint_ == other.fingerprint_;
  }

  // Returns whether crossing edges with these sides makes the other list of this one, with the same certainty, in O(s).
  [[nodiscard]] bool leads_to(const NodeList& other, std::span<const EdgeSide> sides) const {
    return fingerprint_ + fingerprint_of(sides) == other.fingerprint_;
  }

 private:
  [[nodiscard]] static std::uint64_t fingerprint_of(std::span<const EdgeSide> sides);
  [[nodiscard]] bool cross_one(const EdgeSide& side, bool stays, DepthOrder& depth);
  [[nodiscard]] bool cross_all(std::span<const EdgeSide> sides, bool stays, DepthOrder& depth);
  void insert(const Node& node, const DepthOrder& depth);
  [[nodiscard]] bool is_topmost_nearer_than(FacetId other, DepthOrder& depth);
  [[nodiscard]] bool is_nearest(std::size_t node, DepthOrder& depth);

  boost::container::small_vector<Node, 8> nodes_;
  FacetId topmost_;
  bool is_topmost_nearest_ = true;  // than all others; as nothing is, where the list is empty
  bool may_swap_ = false;
  std::uint64_t fingerprint_ = 0;  // the sum over facets of winding * a hash of the facet
};

}  // namespace sightline::inline sweep
