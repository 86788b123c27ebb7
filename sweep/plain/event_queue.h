// The event queue: sweep points from top to bottom, then left to right.
//
// Vertices are sorted once, as the scene's points; crossings wait in a heap. All that coincides, exactly, is one
// sweep point.
// A crossing waits as its height, rounded, and its two edges: most comparisons need no more than heights, and the
// others compute the place anew.
// Complexity: O(log k) per crossing, O(1) per vertex.
// Source: Fang 1993, appendix B (the priority queue and DeleteSameSPs).
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <vector>

#include "geometry/numbers/exact_integer.h"
#include "geometry/numbers/ids.h"

namespace sightline::inline sweep {

struct SweepCrossing {
  EdgeId a;  // left of b above the point
  EdgeId b;
  friend auto operator<=>(const SweepCrossing&, const SweepCrossing&) = default;
};

struct SweepPoint {
  PointId vertex;                                              // invalid: only crossings here
  PointId next_vertex;                                         // the scene's points before it have smaller ids
  boost::container::small_vector<SweepCrossing, 2> crossings;  // distinct pairs, by their edges
};

// The decider is one of decider.h; it outlives the queue.
template <class Decider>
class EventQueue {
 public:
  EventQueue(const Decider& decider, std::size_t vertex_count) : decider_(&decider), vertex_count_(vertex_count) {}

  // Adds two edges that cross: a is left of b above the point.
  void add(EdgeId a, EdgeId b) {
    heap_.push_back({decider_->height(a, b), {a, b}});
    std::push_heap(heap_.begin(), heap_.end(), comes_after());
  }

  // Takes the next sweep point with everything that happens there. Returns false where none is left.
  [[nodiscard]] bool next(SweepPoint& point) {
    point.crossings.clear();
    point.vertex = {};
    const bool vertex_left = next_vertex_ < vertex_count_;
    if (!vertex_left && heap_.empty()) return false;
    const int order = !vertex_left ? -1 : heap_.empty() ? 1 : compare(heap_.front(), PointId(next_vertex_));
    if (order >= 0) point.vertex = PointId(next_vertex_++);
    point.next_vertex = PointId(next_vertex_);
    if (order <= 0) take_crossings_at_first(point);
    return true;
  }

 private:
  struct Event {
    typename Decider::Height height;
    SweepCrossing crossing;
  };

  [[nodiscard]] auto comes_after() const {
    return [this](const Event& a, const Event& b) { return compare(a, b) > 0; };
  }

  // A pair is in the heap once for each time its edges became neighbours. So equal pairs are often compared, which needs
  // no arithmetic.
  [[nodiscard]] int compare(const Event& a, const Event& b) const {
    if (const int by_height = decider_->compare_heights(a.height, b.height); by_height != 0) return by_height;
    if (a.crossing == b.crossing) return 0;
    return decider_->compare(place_of(a), place_of(b));
  }

  [[nodiscard]] int compare(const Event& event, PointId vertex) const {
    const int by_height = decider_->compare_heights(event.height, decider_->height(vertex));
    return by_height != 0 ? by_height : decider_->compare(place_of(event), vertex);
  }

  [[nodiscard]] typename Decider::Place place_of(const Event& event) const {
    return decider_->place(event.crossing.a, event.crossing.b);
  }

  void take_crossings_at_first(SweepPoint& point) {
    const Event first = pop();
    auto& crossings = point.crossings;
    crossings.push_back(first.crossing);
    while (!heap_.empty() && compare(heap_.front(), first) == 0) crossings.push_back(pop().crossing);
    if (crossings.size() == 1) return;
    std::sort(crossings.begin(), crossings.end());
    crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
  }

  Event pop() {
    std::pop_heap(heap_.begin(), heap_.end(), comes_after());
    const Event event = heap_.back();
    heap_.pop_back();
    return event;
  }

  const Decider* decider_;
  std::size_t vertex_count_ = 0;
  std::size_t next_vertex_ = 0;
  std::vector<Event> heap_;
};

}  // namespace sightline::inline sweep
