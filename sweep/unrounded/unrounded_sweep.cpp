#include "sweep/unrounded/unrounded_sweep.h"

#include "sweep/plain/sweep_loop.h"
#include "sweep/unrounded/swaps.h"

namespace sightline::inline sweep {

VisibleSegments unrounded_sweep(const ProjectedScene& scene, std::span<const DepthRange> depths,
                                SweepObserver* observer, UnroundedCounts* counts) {
  const UnroundedDecider decider(scene);
  VisibleSegments segments = Sweep(scene, decider, depths, observer).run();
  segments.swap_edges = decider.swap_edges();
  if (counts != nullptr) *counts = decider.counts();
  return segments;
}

}  // namespace sightline::inline sweep
