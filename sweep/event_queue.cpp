#include "sweep/event_queue.h"

#include <algorithm>

namespace sightline {
namespace {

bool later(const CrossingEvent& a, const CrossingEvent& b) { return sweep_compare(a.point, b.point) > 0; }

bool pair_before(const CrossingEvent& a, const CrossingEvent& b) { return a.a != b.a ? a.a < b.a : a.b < b.b; }

bool same_pair(const CrossingEvent& a, const CrossingEvent& b) { return a.a == b.a && a.b == b.b; }

}  // namespace

void EventQueue::add(const CrossingEvent& crossing) {
  heap_.push_back(crossing);
  std::push_heap(heap_.begin(), heap_.end(), later);
}

CrossingEvent EventQueue::pop_crossing() {
  std::pop_heap(heap_.begin(), heap_.end(), later);
  const CrossingEvent crossing = heap_.back();
  heap_.pop_back();
  return crossing;
}

bool EventQueue::next(SweepPoint& point) {
  point = {};
  const bool vertex_left = next_vertex_ < scene_->points.size();
  if (!vertex_left && heap_.empty()) return false;
  const int order = !vertex_left    ? -1
                    : heap_.empty() ? 1
                                    : sweep_compare(heap_.front().point, scene_->points[next_vertex_]);
  if (order >= 0) point.vertex = PointId(next_vertex_++);
  point.next_vertex = PointId(next_vertex_);
  if (order <= 0) take_crossings_at_first(point);
  return true;
}

// A pair is in the heap once for each time its edges became neighbours.
void EventQueue::take_crossings_at_first(SweepPoint& point) {
  auto& crossings = point.crossings;
  crossings.push_back(pop_crossing());
  while (!heap_.empty() && sweep_compare(heap_.front().point, crossings.front().point) == 0) {
    crossings.push_back(pop_crossing());
  }
  std::sort(crossings.begin(), crossings.end(), pair_before);
  crossings.erase(std::unique(crossings.begin(), crossings.end(), same_pair), crossings.end());
}

}  // namespace sightline
