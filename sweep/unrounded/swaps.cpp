#include "sweep/unrounded/swaps.h"

#include <algorithm>
#include <array>

namespace sightline::inline sweep {

Swaps::Swaps(const UnroundedDecider& decider, const ProjectedScene& scene, DepthOrder& depth, ActiveEdgeList& active)
    : decider_(decider), scene_(scene), depth_(depth), active_(active) {
  depth_.set_local_order(this);
}

void Swaps::begin(const SweepPoint& point) {
  vertex_ = point.vertex;
  if (!vertex_.valid()) crossing_ = {point.crossings.front().a, point.crossings.front().b};
  near_crossing_.reset();
  direction_ = EdgeId{};
}

Sign Swaps::side_of_point(EdgeId swap_edge) const {
  if (vertex_.valid()) return decider_.side(swap_edge, vertex_);
  if (!near_crossing_) near_crossing_ = decider_.filtered_place(crossing_);
  return decider_.side(swap_edge, crossing_, *near_crossing_);
}

// Where both are equally near at the point, it is decided along the direction, and where they are so all along it, right of
// it. Without a direction nobody wants to know who is nearer.
DepthRelation Swaps::relation_here(FacetId f, FacetId g) {
  const EdgeId edge = decider_.swap_edge(f, g);
  if (!decider_.is_seen(edge)) return {decider_.nearer_side(edge, f) > 0, false};
  Sign side = side_of_point(edge);
  if (side == 0 && direction_.valid()) side = -decider_.turn(direction_, edge);
  if (side == 0) side = 1;
  return {side == decider_.nearer_side(edge, f), true};
}

// Calls visit(g, edge) for the facets that pass through the topmost one.
template <class Visit>
void Swaps::for_each_partner(const NodeList& list, Visit visit) {
  if (!list.may_swap()) return;
  const FacetId topmost = list.topmost();
  for (const Node& node : list.nodes()) {
    if (depth_.range(node.facet).nearest > depth_.range(topmost).farthest) break;
    if (node.facet == topmost || !depth_.pass_through(topmost, node.facet)) continue;
    const EdgeId edge = decider_.swap_edge(topmost, node.facet);
    if (decider_.is_seen(edge)) visit(node.facet, edge);
  }
}

// Returns the first swap strictly between two edges through the point; where an edge is invalid, the span is open there. Of
// several along one line it is the one that brings the nearest facet to the top.
Swaps::Swap Swaps::next_swap(const NodeList& list, EdgeId left, EdgeId right) {
  Swap first;
  for_each_partner(list, [&](FacetId g, EdgeId edge) {
    if (side_of_point(edge) != 0 || decider_.nearer_side(edge, list.topmost()) > 0) return;
    if (left.valid() && decider_.turn(left, edge) <= 0) return;
    if (right.valid() && decider_.turn(edge, right) <= 0) return;
    const Sign before = first.edge.valid() ? decider_.turn(edge, first.edge) : 1;
    look_right_of(edge);
    if (before > 0 || (before == 0 && depth_.nearer(g, first.to))) first = {edge, g};
  });
  return first;
}

// `at` is the bundle before, and then the last one that is added.
void Swaps::insert_between(BundleId& at, NodeList list, EdgeId left, EdgeId right) {
  for (Swap swap = next_swap(list, left, right); swap.edge.valid(); swap = next_swap(list, left, right)) {
    at = active_.insert_after(at);
    active_.set_edges(at, {});
    active_.add_edge(at, swap.edge);
    list.swap_topmost(swap.to);
    active_[at].right = list;
    below_.push_back(at);
    left = swap.edge;
  }
}

void Swaps::insert(BundleId left_neighbour, const NodeList& left, std::vector<BundleId>& below) {
  const auto may_swap = [this](BundleId b) { return active_[b].right.may_swap(); };
  if (!left.may_swap() && std::ranges::none_of(below, may_swap)) return;
  const NodeList left_list = left;
  BundleId at = left_neighbour;
  EdgeId border;
  below_.clear();
  for (std::size_t i = 0; i <= below.size(); ++i) {
    const EdgeId next = i < below.size() ? active_[below[i]].edges.front() : EdgeId{};
    insert_between(at, i == 0 ? left_list : active_[below[i - 1]].right, border, next);
    if (i == below.size()) break;
    at = below[i];
    border = next;
    below_.push_back(at);
  }
  below = below_;
  name_swaps_along_edges(left_list, below);
}

// Facets may change places along an edge of other facets: its bundle then has their swap edge, too, since what is seen
// changes along that.
void Swaps::name_swaps_along_edges(const NodeList& left, std::span<const BundleId> below) {
  FacetId before = left.topmost();
  for (const BundleId b : below) {
    const FacetId after = active_[b].right.topmost();
    const EdgeId front = active_[b].edges.front();
    if (before.valid() && after.valid() && before != after && !decider_.is_swap_edge(front) &&
        depth_.pass_through(before, after)) {
      const EdgeId edge = decider_.swap_edge(before, after);
      if (decider_.is_seen(edge) && side_of_point(edge) == 0 && decider_.turn(front, edge) == 0)
        active_.add_edge(b, edge);
    }
    before = after;
  }
}

void Swaps::queue(BundleId left_neighbour, BundleId right_neighbour, std::span<const BundleId> below,
                  EventQueue<UnroundedDecider>& queue) {
  BundleId left = left_neighbour;
  for (const BundleId b : below) {
    queue_along_borders(left, b, queue);
    left = b;
  }
  queue_along_borders(left, right_neighbour, queue);
}

void Swaps::queue_along_borders(BundleId left, BundleId right, EventQueue<UnroundedDecider>& queue) {
  if (!left.valid() || !right.valid()) return;
  const NodeList& list = active_[left].right;
  for_each_partner(list, [&](FacetId /*g*/, EdgeId swap_edge) {
    // Above the border the line is outside of the span.
    const EdgeId left_border = active_[left].edges.front();
    const EdgeId right_border = active_[right].edges.front();
    if (comes_to_the_top(swap_edge, list.topmost(), left_border)) queue_once(swap_edge, left_border, queue);
    if (comes_to_the_top(swap_edge, list.topmost(), right_border)) queue_once(right_border, swap_edge, queue);
  });
}

void Swaps::queue_once(EdgeId a, EdgeId b, EventQueue<UnroundedDecider>& queue) {
  if (queued_.insert(std::uint64_t{a.value} << 32 | b.value).second) queue.add(a, b);
}

// The topmost facet is the nearer one at the height of the sweep. So it is no more, below, where it is not at the border's end;
// and a border without an end meets the line once.
bool Swaps::comes_to_the_top(EdgeId swap_edge, FacetId topmost, EdgeId border) const {
  if (swap_edge == border) return false;
  if (!decider_.is_swap_edge(border))
    return decider_.side(swap_edge, scene_.edge(border).bottom) == -decider_.nearer_side(swap_edge, topmost);
  if (decider_.turn(swap_edge, border) == 0) return false;
  const UnroundedDecider::Place meeting = UnroundedDecider::place(swap_edge, border);
  return (vertex_.valid() ? decider_.compare(meeting, vertex_) : decider_.compare(meeting, crossing_)) > 0;
}

}  // namespace sightline::inline sweep
