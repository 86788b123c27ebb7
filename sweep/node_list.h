// The node list: the facets over one span of the sweep line, shallowest first (Fang 5.3.1).
//
// Holds: no facet twice, no winding number 0; in the order of depth, each node is nearer than the next. Lists with the same contents that are kept by tournament have the same
// topmost facet. Right of a bundle = left of it, minus the facets that leave, plus those that enter.
#pragma once

#include <boost/container/small_vector.hpp>
#include <span>

#include "geometry/ids.h"
#include "geometry/projected_scene.h"
#include "sweep/depth_order.h"

namespace sightline {

// How the topmost facet is found.
//   - depth: the list is sorted by depth. Exact and fast where DepthOrder is transitive, as it is but for facets
//     that overlap in the rounded image only.
//   - tournament: the list is sorted by facet, and the topmost is who is left when each in turn meets the best so far.
//     It depends on the contents alone, so that the subdivision closes whatever the depths say.
enum class NodeOrder { depth, tournament };

struct Node {
  FacetId facet;
  std::int32_t winding = 0;
};

class NodeList {
 public:
  // Invalid where no facet is over the span.
  [[nodiscard]] FacetId topmost() const { return topmost_; }
  [[nodiscard]] std::span<const Node> nodes() const { return {nodes_.data(), nodes_.size()}; }

  // Crosses edges with these sides, all of one bundle, from left to right. O(d + s log s) for d facets in the list and s
  // sides, and O(d) plus a logarithm of depth comparisons for each facet that enters.
  void cross(std::span<const EdgeSide> sides, DepthOrder& depth, NodeOrder order);

  // Whether both hold the same facets with the same winding numbers, in whatever order. O(1): compares a fingerprint
  // that differs for different contents with all but certainty.
  [[nodiscard]] bool same_contents(const NodeList& other) const {
    return nodes_.size() == other.nodes_.size() && fingerprint_ == other.fingerprint_;
  }

 private:
  void insert(const Node& node, DepthOrder& depth, NodeOrder order);
  void remove_leaving(DepthOrder& depth, NodeOrder order);
  void sort_by_depth(DepthOrder& depth);
  [[nodiscard]] FacetId find_topmost(DepthOrder& depth, NodeOrder order) const;

  boost::container::small_vector<Node, 4> nodes_;
  FacetId topmost_;
  std::uint64_t fingerprint_ = 0;  // the sum over facets of winding * a hash of the facet
};

}  // namespace sightline
