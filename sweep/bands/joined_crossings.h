// The crossings that several bands have found, each once.
//
// In:  those that what is used of the bands has as its points, in the whole's edges.
// Out: all of them in sweep order, and their names among the whole's points. Where several bands name a crossing, they
//      give it the same name (segment_recorder.h).
// Complexity: O(n log n); name: O(log n).
#pragma once

#include <tuple>
#include <utility>
#include <vector>

#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

class JoinedCrossings {
 public:
  JoinedCrossings(const ProjectedScene& scene, const std::vector<Crossing>& crossings);

  // Precondition: it is one of them.
  [[nodiscard]] PointId name(const Crossing& crossing) const;
  [[nodiscard]] const std::vector<Crossing>& all() const { return crossings_; }

 private:
  using Key = std::tuple<PointId, EdgeId, EdgeId>;
  static Key key_of(const Crossing& c) { return {c.after, c.a, c.b}; }

  std::size_t vertices_;
  std::vector<Crossing> crossings_;
  std::vector<std::pair<Key, std::size_t>> index_;
};

}  // namespace sightline::inline sweep
