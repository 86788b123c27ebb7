#include "sweep/node_list.h"

#include <algorithm>
#include <utility>

#include "geometry/mix.h"

namespace sightline {
namespace {

// Per facet, by how much its winding number changes.
using Changes = boost::container::small_vector<Node, 8>;

template <class Nodes>
void drop_zeros(Nodes& nodes) {
  const auto is_zero = [](const Node& node) { return node.winding == 0; };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), is_zero), nodes.end());
}

// One change per facet, by facet, none of them 0. A bundle may have several sides of one facet.
Changes changes_of(std::span<const EdgeSide> sides) {
  Changes changes;
  for (const EdgeSide& side : sides) changes.push_back({side.facet, side.winding});
  std::sort(changes.begin(), changes.end(), [](const Node& a, const Node& b) { return a.facet < b.facet; });
  for (std::size_t i = 1; i < changes.size(); ++i) {
    if (changes[i - 1].facet == changes[i].facet) changes[i].winding += std::exchange(changes[i - 1].winding, 0);
  }
  drop_zeros(changes);
  return changes;
}

Node* change_of(FacetId facet, Changes& changes) {
  if (changes.empty() || facet < changes.front().facet || changes.back().facet < facet) return nullptr;
  const auto before = [](const Node& change, FacetId f) { return change.facet < f; };
  const auto found = std::lower_bound(changes.begin(), changes.end(), facet, before);
  return found->facet == facet ? &*found : nullptr;
}

}  // namespace

// One pass over the list, however many facets change: thousands of edges may coincide. Facets that leave go first, so
// that those that enter are compared with as few as possible.
void NodeList::cross(std::span<const EdgeSide> sides, DepthOrder& depth, NodeOrder order) {
  Changes changes = changes_of(sides);
  for (const Node& change : changes)
    fingerprint_ += static_cast<std::uint64_t>(static_cast<std::int64_t>(change.winding)) * mix(change.facet.value);
  for (Node& node : nodes_) {
    if (Node* change = change_of(node.facet, changes)) node.winding += std::exchange(change->winding, 0);
  }
  remove_leaving(depth, order);
  drop_zeros(changes);
  for (const Node& entering : changes) insert(entering, depth, order);
  topmost_ = find_topmost(depth, order);
}

// A facet that leaves may have been a phantom, over the span in the rounded image only: others may have come on the wrong
// side of each other because of their order with it. So those that become neighbours are compared.
void NodeList::remove_leaving(DepthOrder& depth, NodeOrder order) {
  bool in_order = true;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].winding == 0) continue;
    if (order == NodeOrder::depth && kept > 0 && nodes_[i - 1].winding == 0)
      in_order = in_order && depth.nearer(nodes_[kept - 1].facet, nodes_[i].facet);
    nodes_[kept++] = nodes_[i];
  }
  nodes_.resize(kept);
  if (!in_order) sort_by_depth(depth);
}

// Insertion sort ends whatever the order is.
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
