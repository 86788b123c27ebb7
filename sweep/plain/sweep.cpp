#include "sweep/plain/sweep.h"

#include "geometry/numbers/arithmetic.h"
#include "sweep/plain/sweep_loop.h"

namespace sightline::inline sweep {

VisibleSegments plain_sweep(const ProjectedScene& scene, SweepObserver* observer) {
  const bool is_exact = scene.arithmetic == Arithmetic::exact;
  return plain_sweep(scene, is_exact ? depth_ranges(scene) : std::vector<DepthRange>{}, observer);
}

VisibleSegments plain_sweep(const ProjectedScene& scene, std::span<const DepthRange> depths, SweepObserver* observer) {
  const auto swept = [&](const auto& decider) { return Sweep(scene, decider, depths, observer).run(); };
  if (scene.arithmetic == Arithmetic::exact) return swept(GridDecider<ExactDecisions>(scene));
  return with_invariants_of(scene.arithmetic, [&] {
    return scene.arithmetic == Arithmetic::single_precision ? swept(GridDecider<UnfilteredDecisions<float>>(scene))
                                                            : swept(GridDecider<UnfilteredDecisions<double>>(scene));
  });
}

}  // namespace sightline::inline sweep
