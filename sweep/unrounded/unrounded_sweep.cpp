#include "sweep/unrounded/unrounded_sweep.h"

#include "sweep/plain/sweep_loop.h"
#include "sweep/unrounded/swaps.h"

namespace sightline::inline sweep {

UnroundedDecider::Place UnroundedSegments::crossing(PointId p) const {
  const Crossing& crossing = segments.crossings[p.index() - vertex_count];
  return {crossing.a, crossing.b};
}

ExactPlace UnroundedSegments::exact(PointId p) const {
  return p.index() < vertex_count ? decider->exact(p) : decider->exact(crossing(p));
}

std::array<double, 2> UnroundedSegments::in_window(PointId p) const {
  return p.index() < vertex_count ? decider->in_window(p) : decider->in_window(crossing(p));
}

const CertifiedPlace& UnroundedSegments::certified(PointId p) const {
  return p.index() < vertex_count ? decider->certified(p) : decider->certified(crossing(p));
}

UnroundedSegments unrounded_sweep(const UnroundedScene& scene) {
  UnroundedSegments result{{}, std::make_unique<UnroundedDecider>(scene), scene.places.size()};
  const std::vector<DepthRange> depths = depth_ranges(scene.scene);
  result.segments = Sweep(scene.scene, *result.decider, depths, nullptr).run();
  return result;
}

}  // namespace sightline::inline sweep
