#include "sweep/plain/node_list.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/numbers/mix.h"

namespace sightline::inline sweep {
namespace {

// A change says by how much the winding number of a facet changes.
using Changes = boost::container::small_vector<Node, 8>;

template <class Nodes>
void drop_zeros(Nodes& nodes) {
  const auto is_zero = [](const Node& node) { return node.winding == 0; };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), is_zero), nodes.end());
}

// Returns one change per facet, sorted by facet, none of them 0. A bundle may have several sides of one facet.
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

// Returns those facets that are not deeper than all of another. The list is sorted by where depths begin.
std::vector<FacetId> in_range(std::span<const Node> nodes, const DepthOrder& depth) {
  std::vector<FacetId> facets;
  double least_deep_end = std::numeric_limits<double>::infinity();
  for (const Node& node : nodes) {
    const DepthRange& range = depth.range(node.facet);
    if (range.nearest > least_deep_end) break;
    least_deep_end = std::min(least_deep_end, range.farthest);
    facets.push_back(node.facet);
  }
  return facets;
}

// Whoever is nearer than most others is in the top cycle, and so is whoever is nearer than one in it.
std::vector<FacetId> top_cycle_of(const std::vector<FacetId>& facets, DepthOrder& depth) {
  const auto is_nearer = [&](FacetId f, FacetId g) { return f != g && depth.nearer(f, g); };
  const auto count_behind = [&](FacetId f) {
    return std::count_if(facets.begin(), facets.end(), [&](FacetId g) { return is_nearer(f, g); });
  };
  std::vector<FacetId> others = facets;
  std::vector<FacetId> cycle{*std::ranges::max_element(facets, {}, count_behind)};
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    std::erase(others, cycle[i]);
    for (const FacetId f : others) {
      if (is_nearer(f, cycle[i])) cycle.push_back(f);
    }
    std::erase_if(others, [&](FacetId f) { return std::ranges::find(cycle, f) != cycle.end(); });
  }
  return cycle;
}

}  // namespace

void NodeList::cross(std::span<const EdgeSide> sides, DepthOrder& depth) {
  fingerprint_ += fingerprint_of(sides);
  bool stays = is_topmost_nearest_ && topmost_.valid();
  stays = sides.size() == 1 ? cross_one(sides.front(), stays, depth) : cross_all(sides, stays, depth);
  if (!stays) find_topmost(depth);
}

std::uint64_t NodeList::fingerprint_of(std::span<const EdgeSide> sides) {
  std::uint64_t sum = 0;
  for (const EdgeSide& side : sides)
    sum += static_cast<std::uint64_t>(static_cast<std::int64_t>(side.winding)) * mix(side.facet.value);
  return sum;
}

// `stays` says whether the topmost facet stays what it is where it does not leave and nothing nearer enters. Both
// return whether that is so.
bool NodeList::cross_one(const EdgeSide& side, bool stays, DepthOrder& depth) {
  const auto found = std::ranges::find(nodes_, side.facet, &Node::facet);
  if (found == nodes_.end()) {
    insert({side.facet, side.winding}, depth);
    return stays && is_topmost_nearer_than(side.facet, depth);
  }
  found->winding += side.winding;
  if (found->winding != 0) return stays;
  nodes_.erase(found);
  return stays && side.facet != topmost_;
}

// One pass over the list has to do, however many facets change: thousands of edges may coincide.
bool NodeList::cross_all(std::span<const EdgeSide> sides, bool stays, DepthOrder& depth) {
  Changes changes = changes_of(sides);
  for (Node& node : nodes_) {
    if (Node* change = change_of(node.facet, changes)) node.winding += std::exchange(change->winding, 0);
    stays = stays && (node.winding != 0 || node.facet != topmost_);
  }
  drop_zeros(nodes_);
  drop_zeros(changes);
  for (const Node& entering : changes) {
    insert(entering, depth);
    stays = stays && is_topmost_nearer_than(entering.facet, depth);
  }
  return stays;
}

void NodeList::insert(const Node& node, const DepthOrder& depth) {
  const double nearest = depth.range(node.facet).nearest;
  const auto place = std::partition_point(nodes_.begin(), nodes_.end(), [&](const Node& other) {
    const double begin = depth.range(other.facet).nearest;
    return begin < nearest || (begin == nearest && other.facet < node.facet);
  });
  nodes_.insert(place, node);
}

bool NodeList::is_topmost_nearer_than(FacetId other, DepthOrder& depth) {
  const DepthRelation relation = depth.relation(topmost_, other);
  may_swap_ = may_swap_ || relation.passes_through;
  return relation.nearer;
}

// The nearest one, if there is one, is left when each in turn meets the best so far. So it meets all that are in range.
void NodeList::find_topmost(DepthOrder& depth) {
  topmost_ = {};
  is_topmost_nearest_ = true;
  may_swap_ = false;
  if (nodes_.empty()) return;
  std::size_t best = 0;
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    if (depth.range(nodes_[best].facet).farthest < depth.range(nodes_[i].facet).nearest) break;
    const DepthRelation relation = depth.relation(nodes_[i].facet, nodes_[best].facet);
    may_swap_ = (may_swap_ && !relation.nearer) || relation.passes_through;
    if (relation.nearer) best = i;
  }
  is_topmost_nearest_ = is_nearest(best, depth);
  topmost_ = nodes_[best].facet;
  if (!is_topmost_nearest_) topmost_ = std::ranges::min(top_cycle(depth));
}

std::vector<FacetId> NodeList::top_cycle(DepthOrder& depth) const {
  if (is_topmost_nearest_) return {topmost_};
  return top_cycle_of(in_range(nodes(), depth), depth);
}

// Only the nodes before it are asked: those after it have met it.
bool NodeList::is_nearest(std::size_t node, DepthOrder& depth) {
  return std::ranges::all_of(nodes().first(node), [&](const Node& other) {
    const DepthRelation relation = depth.relation(nodes_[node].facet, other.facet);
    may_swap_ = may_swap_ || relation.passes_through;
    return relation.nearer;
  });
}

}  // namespace sightline::inline sweep
