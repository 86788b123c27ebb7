// The event queue: sweep points from top to bottom, then left to right.
//
// Vertices are sorted once, as the scene's points; crossings wait in a heap. All that coincides, exactly, is one
// sweep point.
// Complexity: O(log k) per crossing, O(1) per vertex.
// Source: Fang 1993, appendix B (the priority queue and DeleteSameSPs).
#pragma once

#include <boost/container/small_vector.hpp>
#include <vector>

#include "geometry/projected_scene.h"
#include "sweep/crossing_point.h"

namespace sightline {

struct CrossingEvent {
  CrossingPoint point;
  EdgeId a;  // left of b above the point
  EdgeId b;
};

struct SweepPoint {
  PointId vertex;                                              // invalid: only crossings here
  PointId next_vertex;                                         // the scene's points before this one have smaller ids
  boost::container::small_vector<CrossingEvent, 2> crossings;  // distinct pairs, by their edges
};

class EventQueue {
 public:
  explicit EventQueue(const ProjectedScene& scene) : scene_(&scene) {}

  void add(const CrossingEvent& crossing);

  // Takes the next sweep point with everything that happens there. False where none is left.
  [[nodiscard]] bool next(SweepPoint& point);

 private:
  void take_crossings_at_first(SweepPoint& point);
  CrossingEvent pop_crossing();

  const ProjectedScene* scene_;
  std::size_t next_vertex_ = 0;
  std::vector<CrossingEvent> heap_;
};

}  // namespace sightline
