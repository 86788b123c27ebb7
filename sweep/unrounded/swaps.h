// Facets that pass through each other change places along their common line, where that is seen.
//
// In:  a sweep at one point after the other, with its node lists; the order of depth there.
// Out: swap edges in the active edge list, each between the facet that is topmost on its left and the one on its right; in the
//      event queue, where another facet will come to the top along a border of a span.
// Method: the topmost facet T of a span is the nearest all over it until a facet g of the span's list, one that passes through
//      T, comes to the front: along their swap edge. That enters the span through one of its two borders, or at a sweep point.
//      So, first, for every span and every such g the place is queued where the swap edge meets a border below, if g is in
//      front of T at the border's lower end. And, second, at every sweep point each swap edge through it that leads into a
//      span below becomes a bundle, if T is in front on its left and g on its right; of several the leftmost first, and then
//      those of the facet that it brings to the top. Swap edges end at every sweep point on them, and begin anew where they
//      are still seen: so none has to be followed where it is hidden.
// Holds: since no place is rounded, going around a point meets every change of order that there is, and the topmost facet
//      right of the point comes out as it was before; the sweep checks it.
// Complexity: O(1) for a span whose topmost facet passes through none; else O(d) for its list of d facets, and a comparison
//      with each in whose range of depth it is.
// Source: docs/design.md, section 9. Rejected: to cut facets along their common lines before the sweep, which looks for all
// pairs of facets that pass through each other, seen or not, and makes many pieces of them.
#pragma once

#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "sweep/plain/active_edge_list.h"
#include "sweep/plain/depth_order.h"
#include "sweep/plain/event_queue.h"
#include "sweep/unrounded/unrounded_decider.h"

namespace sightline::inline sweep {

class Swaps : private LocalOrder {
 public:
  Swaps(const UnroundedDecider& decider, const ProjectedScene& scene, DepthOrder& depth, ActiveEdgeList& active);
  Swaps(const Swaps&) = delete;
  Swaps& operator=(const Swaps&) = delete;

  // The sweep is at this point from here on, and just right of no edge.
  void begin(const SweepPoint& point);

  // The order of facets that pass through each other is asked for just below the point, right of this edge through it.
  void look_right_of(EdgeId edge) { direction_ = edge; }

  // Adds the swap edges that begin here to the active edge list and to the bundles below the point. `left` is the list of the
  // span left of them.
  void insert(BundleId left_neighbour, const NodeList& left, std::vector<BundleId>& below);

  // Queues the swaps that are expected along the borders of the spans around the point.
  void queue(BundleId left_neighbour, BundleId right_neighbour, std::span<const BundleId> below,
             EventQueue<UnroundedDecider>& queue);

 private:
  struct Swap {
    EdgeId edge;  // invalid: none
    FacetId to;
  };

  [[nodiscard]] DepthRelation relation_here(FacetId f, FacetId g) override;
  [[nodiscard]] Sign side_of_point(EdgeId swap_edge) const;
  template <class Visit>
  void for_each_partner(const NodeList& list, Visit visit);
  [[nodiscard]] Swap next_swap(const NodeList& list, EdgeId left, EdgeId right);
  void insert_between(BundleId& at, NodeList list, EdgeId left, EdgeId right);
  void name_swaps_along_edges(const NodeList& left, std::span<const BundleId> below);
  void queue_along_borders(BundleId left, BundleId right, EventQueue<UnroundedDecider>& queue);
  void queue_once(EdgeId a, EdgeId b, EventQueue<UnroundedDecider>& queue);
  [[nodiscard]] bool comes_to_the_top(EdgeId swap_edge, FacetId topmost, EdgeId border) const;

  const UnroundedDecider& decider_;
  const ProjectedScene& scene_;
  DepthOrder& depth_;
  ActiveEdgeList& active_;

  std::unordered_set<std::uint64_t> queued_;  // pairs of edges, which meet but once

  // These belong to the current sweep point.
  PointId vertex_;
  UnroundedDecider::Place crossing_;
  mutable std::optional<CertifiedPlace> near_crossing_;  // as soon as it is asked for
  EdgeId direction_;
  std::vector<BundleId> below_;
};

}  // namespace sightline::inline sweep
