#include "sweep/node_list.h"

#include <algorithm>

#include "geometry/mix.h"

namespace sightline {
// Facets that leave go first, so that those that enter are compared with as few as possible.
void NodeList::cross(std::span<const EdgeSide> sides, DepthOrder& depth, NodeOrder order) {
  const auto present = [this](FacetId f) {
    return std::any_of(nodes_.begin(), nodes_.end(), [f](const Node& node) { return node.facet == f; });
  };
  boost::container::small_vector<EdgeSide, 8> entering;
  for (const EdgeSide& side : sides) {
    if (present(side.facet)) {
      add(side, depth, order);
    } else {
      entering.push_back(side);
    }
  }
  for (const EdgeSide& side : entering) add(side, depth, order);
  topmost_ = find_topmost(depth, order);
}

void NodeList::add(const EdgeSide& side, DepthOrder& depth, NodeOrder order) {
  fingerprint_ += static_cast<std::uint64_t>(static_cast<std::int64_t>(side.winding)) * mix(side.facet.value);
  const auto found =
      std::find_if(nodes_.begin(), nodes_.end(), [&side](const Node& node) { return node.facet == side.facet; });
  if (found == nodes_.end()) {
    insert({side.facet, side.winding}, depth, order);
    return;
  }
  found->winding += side.winding;
  if (found->winding != 0) return;
  const auto after = nodes_.erase(found);
  if (order == NodeOrder::depth && after != nodes_.begin() && after != nodes_.end() &&
      !depth.nearer((after - 1)->facet, after->facet)) {
    sort_by_depth(depth);
  }
}

// The facet that has left was a phantom, over the span in the rounded image only: others came on the wrong side of each
// other because of their order with it. Insertion sort ends whatever the order is.
void NodeList::sort_by_depth(DepthOrder& depth) {
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    for (std::size_t k = i; k > 0 && depth.nearer(nodes_[k].facet, nodes_[k - 1].facet); --k) {
      std::swap(nodes_[k], nodes_[k - 1]);
    }
  }
}

void NodeList::insert(const Node& node, DepthOrder& depth, NodeOrder order) {
  const auto place = std::partition_point(nodes_.begin(), nodes_.end(), [&](const Node& other) {
    return order == NodeOrder::depth ? depth.nearer(other.facet, node.facet) : other.facet < node.facet;
  });
  nodes_.insert(place, node);
}

FacetId NodeList::find_topmost(DepthOrder& depth, NodeOrder order) const {
  if (nodes_.empty()) return FacetId{};
  FacetId best = nodes_.front().facet;
  if (order == NodeOrder::depth) return best;
  for (const Node& node : nodes().subspan(1)) {
    if (depth.nearer(node.facet, best)) best = node.facet;
  }
  return best;
}

}  // namespace sightline
