// The sweep itself, as it is compiled with a decider (decider.h); sweep.h says what comes in and goes out.
//
// Source: Fang 1993, section 5.3.1 and appendix B.
#pragma once

#include <algorithm>
#include <utility>

#include "geometry/numbers/errors.h"
#include "sweep/plain/active_edge_list.h"
#include "sweep/plain/decider.h"
#include "sweep/plain/depth_order.h"
#include "sweep/plain/event_queue.h"
#include "sweep/plain/segment_recorder.h"
#include "sweep/plain/sweep.h"
#include "sweep/plain/sweep_input.h"
#include "sweep/plain/sweep_state.h"
#include "sweep/segments/crossing_point.h"

namespace sightline::inline sweep {

template <class Decider>
class Sweep : private SweepState, private SweptEdges {
 public:
  Sweep(const ProjectedScene& scene, const Decider& decider, std::span<const DepthRange> depths,
        SweepObserver* observer)
      : scene_(scene),
        observer_(observer),
        input_(scene),
        decider_(decider),
        queue_(decider, scene.points.size()),
        active_(scene.edge_count()),
        depth_(scene, depths),
        swaps_(decider, scene, depth_, active_),
        recorder_(scene, *this, depth_, result_) {}

  VisibleSegments run() {
    while (queue_.next(point_)) {
      if (is_over()) continue;
      swaps_.begin(point_);
      find_above();
      arrange_below();
      replace_in_active_list();
      update_node_lists();
      erase_left_over();
      insert_swaps();
      recorder_.record(name_of_point(), above_segments_, below_, left_list(), active_);
      queue_crossings();
      swaps_.queue(left_neighbour_, right_neighbour_, below_, queue_);
      count();
      if (observer_ != nullptr) notify();
    }
    check(active_.empty(), "edges are left over after the last sweep point");
    result_.statistics.depth_comparisons = depth_.comparisons();
    result_.statistics.predicates = depth_.counts();
    require_real_crossings();
    std::sort(result_.splits.begin(), result_.splits.end());
    result_.splits.erase(std::unique(result_.splits.begin(), result_.splits.end()), result_.splits.end());
    return std::move(result_);
  }

 private:
  // A swap edge ends as soon as it is not seen, whatever was expected of it further down.
  [[nodiscard]] bool is_over(EdgeId e) const { return decider_.is_swap_edge(e) && !active_.is_active(e); }
  [[nodiscard]] bool is_over() const {
    return !point_.vertex.valid() && std::ranges::all_of(point_.crossings, [this](const SweepCrossing& c) {
      return is_over(c.a) && is_over(c.b);
    });
  }

  // The bundles through the sweep point are those with edges that end or cross here, and those that a vertex lies on.
  void find_above() {
    above_.clear();
    marked_ = {};
    marked_count_ = 0;
    for (const EdgeId e : input_.ending_at(point_.vertex)) mark(active_.bundle_of(e));
    for (const SweepCrossing& c : point_.crossings) {
      if (!is_over(c.a)) mark(active_.bundle_of(c.a));
      if (!is_over(c.b)) mark(active_.bundle_of(c.b));
    }
    if (!marked_.valid()) {
      search_above();
    } else {
      expand_above();
    }
    above_segments_.clear();
    for (const BundleId b : above_) remember_segments(active_[b]);
  }

  void mark(BundleId b) {
    check(b.valid(), "an edge that should be active is not");
    if (is_marked(b)) return;
    active_[b].mark = sweep_point_number();
    marked_ = b;
    ++marked_count_;
  }

  // No edge leads to a top vertex, so its place is searched.
  void search_above() {
    const PointId p = point_.vertex;
    const BundleId found = active_.find([&](const Bundle& b) { return side_of(b, p) > 0; });
    left_neighbour_ = found.valid() ? active_.previous(found) : active_.last();
    right_neighbour_ = found;
    if (found.valid() && side_of(active_[found], p) == 0) {
      above_.push_back(found);
      right_neighbour_ = active_.next(found);
    }
  }

  // Bundles through one point are next to each other.
  void expand_above() {
    BundleId first = marked_;
    while (active_.previous(first).valid() && passes_through_point(active_.previous(first)))
      first = active_.previous(first);
    left_neighbour_ = active_.previous(first);
    std::size_t found = 0;
    BundleId b = first;
    for (; b.valid() && passes_through_point(b); b = active_.next(b)) {
      above_.push_back(b);
      found += is_marked(b) ? 1 : 0;
    }
    right_neighbour_ = b;
    check(found == marked_count_, "the bundles through the point are not next to each other");
  }

  [[nodiscard]] bool is_marked(BundleId b) const { return active_[b].mark == sweep_point_number(); }
  [[nodiscard]] std::uint64_t sweep_point_number() const { return result_.statistics.sweep_points + 1; }

  [[nodiscard]] bool passes_through_point(BundleId b) const {
    return is_marked(b) || (point_.vertex.valid() && side_of(active_[b], point_.vertex) == 0);
  }

  // Returns +1 where p is right of the bundle, 0 where it is on it.
  [[nodiscard]] Sign side_of(const Bundle& bundle, PointId p) const { return decider_.side(bundle.edges.front(), p); }

  void remember_segments(const Bundle& bundle) {
    if (bundle.left_segment.segment.valid()) above_segments_.push_back({bundle.left_segment, true});
    if (bundle.right_segment.segment.valid()) above_segments_.push_back({bundle.right_segment, false});
  }

  // The edges that leave the point downwards are sorted left to right; those with one direction are one bundle. Swap edges
  // begin anew where they are still seen.
  void arrange_below() {
    edges_below_.clear();
    for (const BundleId b : above_) {
      for (const EdgeId e : active_[b].edges) {
        active_.deactivate(e);
        if (decider_.is_swap_edge(e)) continue;
        if (scene_.edge(e).bottom != point_.vertex) edges_below_.push_back(e);
      }
    }
    const auto starting = input_.starting_at(point_.vertex);
    edges_below_.insert(edges_below_.end(), starting.begin(), starting.end());
    std::sort(edges_below_.begin(), edges_below_.end(), [this](EdgeId a, EdgeId b) {
      const Sign turn = decider_.turn(a, b);
      return turn != 0 ? turn > 0 : a < b;
    });
  }

  // The entries of the bundles above are used again for those below: the last one for the last, since the list right of
  // it stays.
  void replace_in_active_list() {
    below_.clear();
    BundleId left = left_neighbour_;
    for (std::size_t begin = 0; begin < edges_below_.size();) {
      std::size_t end = begin + 1;
      while (end < edges_below_.size() && decider_.turn(edges_below_[begin], edges_below_[end]) == 0) ++end;
      left = entry_below(left, end == edges_below_.size());
      active_.set_edges(left, std::span(edges_below_).subspan(begin, end - begin));
      below_.push_back(left);
      begin = end;
    }
  }

  [[nodiscard]] BundleId entry_below(BundleId left, bool is_last) {
    if (!above_.empty() && is_last) return above_.back();
    return below_.size() + 1 < above_.size() ? above_[below_.size()] : active_.insert_after(left);
  }

  void erase_left_over() {
    if (above_.empty()) return;
    for (std::size_t i = below_.empty() ? 0 : below_.size() - 1; i + 1 < above_.size(); ++i) active_.erase(above_[i]);
    if (below_.empty()) active_.erase(above_.back());
  }

  // The list right of a bundle is the one left of it, minus the facets that leave, plus those that enter. The last span
  // is the one that was there before, unless facets may have changed places along its new border.
  void update_node_lists() {
    const NodeList* list = &left_list();
    const NodeList& last = above_.empty() ? left_list() : active_[above_.back()].right;
    topmost_right_ = last.topmost();
    check(right_neighbour_.valid() || last.nodes().empty(), "the node list right of the last bundle is not empty");
    for (const BundleId b : below_) {
      collect_sides(active_[b]);
      const bool is_last = b == below_.back();
      if (is_last) check(list->leads_to(last, sides_), "the node lists around the point do not agree");
      if (is_last && !list->may_swap() && !last.may_swap()) {
        if (above_.empty()) active_[b].right = left_list();
        break;
      }
      swaps_.look_right_of(active_[b].edges.front());
      NodeList& right = active_[b].right;
      right = *list;
      right.cross(sides_, depth_);
      if (list->may_swap()) right.find_topmost(depth_);
      note_order(right);
      list = &right;
    }
    if (below_.empty()) check(list->same_contents(last), "the node lists around the point do not agree");
  }

  void collect_sides(const Bundle& bundle) {
    sides_.clear();
    for (const EdgeId e : bundle.edges) {
      if (!decider_.is_swap_edge(e)) sides_.insert(sides_.end(), scene_.sides_of(e).begin(), scene_.sides_of(e).end());
    }
  }

  // Returns the list over the span left of the point.
  [[nodiscard]] const NodeList& left_list() const {
    return left_neighbour_.valid() ? active_[left_neighbour_].right : nothing_;
  }

  void note_order(const NodeList& list) {
    bool& is_transitive = result_.statistics.depth_is_transitive;
    is_transitive = is_transitive && list.is_topmost_nearest();
  }

  // Right of the point is what was there before.
  void insert_swaps() {
    swaps_.insert(left_neighbour_, left_list(), below_);
    const NodeList& last = below_.empty() ? left_list() : active_[below_.back()].right;
    check(last.topmost() == topmost_right_, "the topmost facet right of the point is another than before");
  }

  void queue_crossings() {
    if (below_.empty()) {
      queue_crossing(left_neighbour_, right_neighbour_);
    } else {
      queue_crossing(left_neighbour_, below_.front());
      queue_crossing(below_.back(), right_neighbour_);
    }
  }

  // A crossing is queued where two neighbours converge and meet strictly inside both. Where one ends on the other, that
  // is a vertex event already.
  void queue_crossing(BundleId left, BundleId right) {
    if (!left.valid() || !right.valid()) return;
    const EdgeId a = active_[left].edges.front();
    const EdgeId b = active_[right].edges.front();
    if (decider_.turn(a, b) >= 0 || !meet_below(a, b)) return;
    if constexpr (!Decider::is_exact) {
      const auto place = decider_.place(a, b);
      check(Decider::is_number(place), "two edges that cross are parallel");
      check(is_ahead(place), "two edges cross at or above the sweep line");
    }
    queue_.add(a, b);
  }

  // Precondition: they converge. A swap edge has no end.
  [[nodiscard]] bool meet_below(EdgeId a, EdgeId b) const {
    if (decider_.is_swap_edge(a)) return decider_.is_swap_edge(b) || decider_.side(a, scene_.edge(b).bottom) < 0;
    if (decider_.is_swap_edge(b)) return decider_.side(b, scene_.edge(a).bottom) > 0;
    const PointId a_end = scene_.edge(a).bottom;
    const PointId b_end = scene_.edge(b).bottom;
    return a_end < b_end ? decider_.side(b, a_end) > 0 : b_end < a_end && decider_.side(a, b_end) < 0;
  }

  [[nodiscard]] bool is_ahead(const typename Decider::Place& place) const {
    if (point_.vertex.valid()) return decider_.compare(place, point_.vertex) > 0;
    const SweepCrossing& here = point_.crossings.front();
    return decider_.compare(place, decider_.place(here.a, here.b)) > 0;
  }

  // Whoever reads the result finds a crossing by its edges, so they have to cross. Exact decisions are right.
  void require_real_crossings() const {
    if constexpr (!Decider::is_exact) {
      for (const Crossing& c : result_.crossings)
        check(cross_inside_both(scene_, c.a, c.b), "two edges that were taken to cross do not");
    }
  }

  [[nodiscard]] NamedPoint name_of_point() const {
    if (point_.vertex.valid()) return {point_.vertex, {}};
    return {{}, {point_.crossings.front().a, point_.crossings.front().b, point_.next_vertex}};
  }

  void count() {
    SweepStatistics& statistics = result_.statistics;
    ++statistics.sweep_points;
    statistics.crossings += point_.crossings.size();
    const bool on_edge =
        point_.vertex.valid() && std::any_of(edges_below_.begin(), edges_below_.end(),
                                             [this](EdgeId e) { return scene_.edge(e).top != point_.vertex; });
    const bool degenerate = point_.crossings.size() > 1 || on_edge || edges_below_.size() > below_.size() ||
                            (point_.vertex.valid() && input_.has_several_vertices(point_.vertex));
    statistics.degenerate_sweep_points += degenerate ? 1 : 0;
  }

  void notify() const {
    const SweepPlace place = here();
    observer_->on_point({place.vertex, place.x, place.y, place.crossings.size(), point_.next_vertex.index()});
    observer_->on_state(*this);
  }

  [[nodiscard]] SweepPlace here() const override { return place_in_window(decider_, point_); }
  [[nodiscard]] std::vector<SweepPlace> upcoming(std::size_t at_most) const override {
    EventQueue<Decider> rest = queue_;
    std::vector<SweepPlace> places;
    SweepPoint point;
    while (places.size() < at_most && rest.next(point)) places.push_back(place_in_window(decider_, point));
    return places;
  }
  [[nodiscard]] const ActiveEdgeList& active() const override { return active_; }
  [[nodiscard]] std::span<const BundleId> below() const override { return below_; }
  [[nodiscard]] BundleId left_neighbour() const override { return left_neighbour_; }
  [[nodiscard]] const VisibleSegments& so_far() const override { return result_; }

  [[nodiscard]] Sign turn(EdgeId a, EdgeId b) const override { return decider_.turn(a, b); }
  [[nodiscard]] std::array<FacetId, 2> surfaces_of_swap_edge(EdgeId e) const override {
    return decider_.surfaces_of_swap_edge(e);
  }

  void check(bool holds, const char* what) const {
    if (holds) return;
    const std::string where = point_.vertex.valid() ? "vertex " + std::to_string(point_.vertex.value)
                              : point_.crossings.empty()
                                  ? "the end"
                                  : "the crossing of edges " + std::to_string(point_.crossings.front().a.value) +
                                        " and " + std::to_string(point_.crossings.front().b.value);
    throw InternalError(std::string(what) + " (sweep point: " + where + ")");
  }

  const ProjectedScene& scene_;
  SweepObserver* const observer_;
  const SweepInput input_;
  const Decider& decider_;
  EventQueue<Decider> queue_;
  ActiveEdgeList active_;
  DepthOrder depth_;
  typename Decider::Swaps swaps_;
  VisibleSegments result_;
  SegmentRecorder recorder_;

  // These belong to the current sweep point.
  SweepPoint point_;
  BundleId left_neighbour_, right_neighbour_;
  BundleId marked_;  // one of the bundles with edges that end or cross here
  std::size_t marked_count_ = 0;
  std::vector<BundleId> above_, below_;
  std::vector<AboveSegment> above_segments_;
  std::vector<EdgeId> edges_below_;
  std::vector<EdgeSide> sides_;
  FacetId topmost_right_;  // right of the point, at its height
  const NodeList nothing_;
};

}  // namespace sightline::inline sweep
