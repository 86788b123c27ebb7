// The places of crossings in the order of the sweep, on the grid and where nothing is rounded.
//
// In:  a projected scene; swap edges, if there are any.
// Out: -1 where the first comes first, 0 where they are one place. Precondition: the edges of a crossing are not parallel.
// Complexity: O(1) each.
#pragma once

#include <memory>
#include <vector>

#include "sweep/segments/unrounded_image.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

class CrossingOrder {
 public:
  // Both outlive it.
  CrossingOrder(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges);

  [[nodiscard]] int compare(const Crossing& crossing, PointId scene_point) const;
  [[nodiscard]] int compare(const Crossing& a, const Crossing& b) const;

 private:
  const ProjectedScene& scene_;
  const std::unique_ptr<UnroundedImage> unrounded_;  // null on the grid
};

}  // namespace sightline::inline sweep
