#include "sweep/plain/event_queue.h"

#include <algorithm>

namespace sightline::inline sweep {
namespace {

constexpr auto pair_before = [](const CrossingEvent& a, const CrossingEvent& b) {
  return a.a != b.a ? a.a < b.a : a.b < b.b;
};

constexpr auto same_pair = [](const CrossingEvent& a, const CrossingEvent& b) { return a.a == b.a && a.b == b.b; };

}  // namespace

// A pair is in the heap once for each time its edges became neighbours. So equal pairs are often compared, which needs
// no arithmetic.
template <class Decisions>
int EventQueue<Decisions>::compare(const CrossingEvent& a, const CrossingEvent& b) const {
  if (const int by_height = Decisions::compare_heights(a.height, b.height); by_height != 0) return by_height;
  if (same_pair(a, b)) return 0;
  return Decisions::compare(place_of<Decisions>(*scene_, a), place_of<Decisions>(*scene_, b));
}

template <class Decisions>
int EventQueue<Decisions>::compare(const CrossingEvent& crossing, const ImagePoint& vertex) const {
  const int by_height = Decisions::compare_heights(crossing.height, Decisions::height(vertex));
  return by_height != 0 ? by_height : Decisions::compare(place_of<Decisions>(*scene_, crossing), vertex);
}

template <class Decisions>
void EventQueue<Decisions>::add(EdgeId a, EdgeId b) {
  const SceneEdge& of_a = scene_->edge(a);
  const SceneEdge& of_b = scene_->edge(b);
  const double height = Decisions::crossing_height(scene_->point(of_a.top), scene_->point(of_a.bottom),
                                                   scene_->point(of_b.top), scene_->point(of_b.bottom));
  heap_.push_back({height, a, b});
  std::push_heap(heap_.begin(), heap_.end(),
                 [this](const CrossingEvent& c, const CrossingEvent& d) { return compare(c, d) > 0; });
}

template <class Decisions>
CrossingEvent EventQueue<Decisions>::pop_crossing() {
  std::pop_heap(heap_.begin(), heap_.end(),
                [this](const CrossingEvent& a, const CrossingEvent& b) { return compare(a, b) > 0; });
  const CrossingEvent crossing = heap_.back();
  heap_.pop_back();
  return crossing;
}

template <class Decisions>
bool EventQueue<Decisions>::next(SweepPoint& point) {
  point.crossings.clear();
  point.vertex = {};
  const bool vertex_left = next_vertex_ < scene_->points.size();
  if (!vertex_left && heap_.empty()) return false;
  const int order = !vertex_left ? -1 : heap_.empty() ? 1 : compare(heap_.front(), scene_->points[next_vertex_]);
  if (order >= 0) point.vertex = PointId(next_vertex_++);
  point.next_vertex = PointId(next_vertex_);
  if (order <= 0) take_crossings_at_first(point);
  return true;
}

template <class Decisions>
void EventQueue<Decisions>::take_crossings_at_first(SweepPoint& point) {
  auto& crossings = point.crossings;
  crossings.push_back(pop_crossing());
  while (!heap_.empty() && compare(heap_.front(), crossings.front()) == 0) crossings.push_back(pop_crossing());
  if (crossings.size() == 1) return;
  std::sort(crossings.begin(), crossings.end(), pair_before);
  crossings.erase(std::unique(crossings.begin(), crossings.end(), same_pair), crossings.end());
}

template class EventQueue<ExactDecisions>;
template class EventQueue<UnfilteredDecisions<float>>;
template class EventQueue<UnfilteredDecisions<double>>;

}  // namespace sightline::inline sweep
