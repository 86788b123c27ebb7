// The state is what there is to see of a sweep right after a sweep point, for teaching and tracing.
//
// In:  a sweep calls SweepObserver::on_state with its state. Out: where the sweep is, what comes next, the active edge list
//      with its node lists, and the visible segments so far.
// Holds: during the call only. A segment that is open lacks its end (its start where it runs upwards).
// Complexity: upcoming copies the crossings that wait; the rest is O(1). Nothing is computed that is not asked for.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sweep/plain/active_edge_list.h"
#include "sweep/plain/event_queue.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

struct SweepPlace {
  PointId vertex;  // invalid: only crossings here
  double x = 0;    // in the window's units, rounded
  double y = 0;
  std::vector<std::array<EdgeId, 2>> crossings;  // pairs of edges; the first is left of the second above the point
};

class SweepState {
 public:
  virtual ~SweepState() = default;

  [[nodiscard]] virtual SweepPlace here() const = 0;
  // Returns the next sweep points, as far as they are known: at most this many.
  [[nodiscard]] virtual std::vector<SweepPlace> upcoming(std::size_t at_most) const = 0;
  [[nodiscard]] virtual const ActiveEdgeList& active() const = 0;
  // Returns the bundles that leave the point downwards, left to right; the left neighbour is the bundle left of them
  // (invalid: none).
  [[nodiscard]] virtual std::span<const BundleId> below() const = 0;
  [[nodiscard]] virtual BundleId left_neighbour() const = 0;
  [[nodiscard]] virtual const VisibleSegments& so_far() const = 0;
};

template <class Decider>
[[nodiscard]] SweepPlace place_in_window(const Decider& decider, const SweepPoint& point) {
  const bool at_vertex = point.vertex.valid();
  const auto [x, y] = at_vertex ? decider.in_window(point.vertex)
                                : decider.in_window(decider.place(point.crossings[0].a, point.crossings[0].b));
  SweepPlace place{point.vertex, x, y, {}};
  for (const SweepCrossing& crossing : point.crossings) place.crossings.push_back({crossing.a, crossing.b});
  return place;
}

}  // namespace sightline::inline sweep
