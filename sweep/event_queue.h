// The event queue: sweep points from top to bottom, then left to right.
//
// Vertices are sorted once, as the scene's points; crossings wait in a heap. All that coincides, exactly, is one
// sweep point.
// Complexity: O(log k) per crossing, O(1) per vertex.
// Source: Fang 1993, appendix B (the priority queue and DeleteSameSPs).
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <vector>

#include "geometry/projected_scene.h"
#include "sweep/image_decisions.h"

namespace sightline {

template <class Place>
struct CrossingEvent {
  Place point;
  EdgeId a;  // left of b above the point
  EdgeId b;
};

template <class Place>
struct SweepPoint {
  PointId vertex;                                                     // invalid: only crossings here
  PointId next_vertex;                                                // the scene's points before it have smaller ids
  boost::container::small_vector<CrossingEvent<Place>, 2> crossings;  // distinct pairs, by their edges
};

// Decisions: see image_decisions.h.
template <class Decisions>
class EventQueue {
 public:
  using Event = CrossingEvent<typename Decisions::Place>;
  using Point = SweepPoint<typename Decisions::Place>;

  explicit EventQueue(const ProjectedScene& scene) : scene_(&scene) {}

  void add(const Event& crossing);

  // Takes the next sweep point with everything that happens there. False where none is left.
  [[nodiscard]] bool next(Point& point);

 private:
  // Small, since a heap moves its entries around: most comparisons need no more than y.
  struct Entry {
    double y = 0;  // the event's, rounded
    std::uint32_t event = 0;
  };

  [[nodiscard]] int compare(const Entry& a, const Entry& b) const;
  [[nodiscard]] static int compare(const Event& a, const Event& b);
  void take_crossings_at_first(Point& point);
  Event pop_crossing();

  const ProjectedScene* scene_;
  std::size_t next_vertex_ = 0;
  std::vector<Entry> heap_;
  std::vector<Event> events_;
  std::vector<std::uint32_t> free_;  // places in events_
};

extern template class EventQueue<ExactDecisions>;
extern template class EventQueue<UnfilteredDecisions<float>>;
extern template class EventQueue<UnfilteredDecisions<double>>;

}  // namespace sightline
