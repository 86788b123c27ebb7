#include "sweep/event_queue.h"

#include <algorithm>

namespace sightline {
namespace {

constexpr auto pair_before = [](const auto& a, const auto& b) { return a.a != b.a ? a.a < b.a : a.b < b.b; };

constexpr auto same_pair = [](const auto& a, const auto& b) { return a.a == b.a && a.b == b.b; };

}  // namespace

template <class Decisions>
int EventQueue<Decisions>::compare(const Entry& a, const Entry& b) const {
  if (const int by_y = Decisions::compare_rounded(a.y, b.y); by_y != 0) return by_y;
  return compare(events_[a.event], events_[b.event]);
}

// A pair is in the heap once for each time its edges became neighbours: that often, and it needs no arithmetic.
template <class Decisions>
int EventQueue<Decisions>::compare(const Event& a, const Event& b) {
  return same_pair(a, b) ? 0 : Decisions::compare(a.point, b.point);
}

template <class Decisions>
void EventQueue<Decisions>::add(const Event& crossing) {
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(events_.size()));
    events_.emplace_back();
  }
  events_[free_.back()] = crossing;
  heap_.push_back({static_cast<double>(crossing.point.y), free_.back()});
  free_.pop_back();
  std::push_heap(heap_.begin(), heap_.end(), [this](const Entry& a, const Entry& b) { return compare(a, b) > 0; });
}

template <class Decisions>
typename EventQueue<Decisions>::Event EventQueue<Decisions>::pop_crossing() {
  std::pop_heap(heap_.begin(), heap_.end(), [this](const Entry& a, const Entry& b) { return compare(a, b) > 0; });
  const std::uint32_t event = heap_.back().event;
  heap_.pop_back();
  free_.push_back(event);
  return events_[event];
}

template <class Decisions>
bool EventQueue<Decisions>::next(Point& point) {
  point = {};
  const bool vertex_left = next_vertex_ < scene_->points.size();
  if (!vertex_left && heap_.empty()) return false;
  const int order = !vertex_left ? -1
                    : heap_.empty()
                        ? 1
                        : Decisions::compare(events_[heap_.front().event].point, scene_->points[next_vertex_]);
  if (order >= 0) point.vertex = PointId(next_vertex_++);
  point.next_vertex = PointId(next_vertex_);
  if (order <= 0) take_crossings_at_first(point);
  return true;
}

template <class Decisions>
void EventQueue<Decisions>::take_crossings_at_first(Point& point) {
  auto& crossings = point.crossings;
  crossings.push_back(pop_crossing());
  while (!heap_.empty() && compare(events_[heap_.front().event], crossings.front()) == 0) {
    crossings.push_back(pop_crossing());
  }
  std::sort(crossings.begin(), crossings.end(), pair_before);
  crossings.erase(std::unique(crossings.begin(), crossings.end(), same_pair), crossings.end());
}

template class EventQueue<ExactDecisions>;
template class EventQueue<UnfilteredDecisions<float>>;
template class EventQueue<UnfilteredDecisions<double>>;

}  // namespace sightline
