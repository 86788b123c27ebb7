// The event queue: sweep points from top to bottom, then left to right.
//
// Vertices are sorted once, as the scene's points; crossings wait in a heap. All that coincides, exactly, is one
// sweep point.
// A crossing waits as its height, rounded, and its two edges: most comparisons need no more than heights, and the
// others compute the place anew.
// Complexity: O(log k) per crossing, O(1) per vertex.
// Source: Fang 1993, appendix B (the priority queue and DeleteSameSPs).
#pragma once

#include <boost/container/small_vector.hpp>
#include <vector>

#include "geometry/projection/projected_scene.h"
#include "sweep/segments/image_decisions.h"

namespace sightline::inline sweep {

struct CrossingEvent {
  double height = 0;  // y, rounded
  EdgeId a;           // left of b above the point
  EdgeId b;
};

struct SweepPoint {
  PointId vertex;                                              // invalid: only crossings here
  PointId next_vertex;                                         // the scene's points before it have smaller ids
  boost::container::small_vector<CrossingEvent, 2> crossings;  // distinct pairs, by their edges
};

// The decisions are those of image_decisions.h.
template <class Decisions>
[[nodiscard]] typename Decisions::Place place_of(const ProjectedScene& scene, const CrossingEvent& crossing) {
  const SceneEdge& a = scene.edge(crossing.a);
  const SceneEdge& b = scene.edge(crossing.b);
  return Decisions::crossing(scene.point(a.top), scene.point(a.bottom), scene.point(b.top), scene.point(b.bottom));
}

template <class Decisions>
class EventQueue {
 public:
  explicit EventQueue(const ProjectedScene& scene) : scene_(&scene) {}

  // Adds two edges that cross: a is left of b above the point.
  void add(EdgeId a, EdgeId b);

  // Takes the next sweep point with everything that happens there. Returns false where none is left.
  [[nodiscard]] bool next(SweepPoint& point);

 private:
  [[nodiscard]] int compare(const CrossingEvent& a, const CrossingEvent& b) const;
  [[nodiscard]] int compare(const CrossingEvent& crossing, const ImagePoint& vertex) const;
  void take_crossings_at_first(SweepPoint& point);
  CrossingEvent pop_crossing();

  const ProjectedScene* scene_;
  std::size_t next_vertex_ = 0;
  std::vector<CrossingEvent> heap_;
};

extern template class EventQueue<ExactDecisions>;
extern template class EventQueue<UnfilteredDecisions<float>>;
extern template class EventQueue<UnfilteredDecisions<double>>;

}  // namespace sightline::inline sweep
