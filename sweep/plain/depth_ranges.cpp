#include "sweep/plain/depth_ranges.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/bounded.h"
#include "geometry/numbers/parallel.h"
#include "geometry/projection/camera_forms.h"

namespace sightline::inline sweep {
namespace {

// A corner that clipping or cutting made is rounded once.
BoundedVector rounded_once(const Point3& p) {
  return p.unaryExpr([](double c) { return Bounded{c, Bounded::widened(unit_roundoff * std::fabs(c))}; });
}

// A depth that overflows is no number, and bounds nothing.
DepthRange range_of(const Bounded& depth) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(depth.radius < infinity)) return {-infinity, infinity};
  return {depth.value - depth.radius, depth.value + depth.radius};
}

}  // namespace

std::vector<DepthRange> depth_ranges(const ProjectedScene& scene) {
  std::vector<DepthRange> ranges(scene.status.size());
  const CameraForms<Bounded> forms(scene.camera);
  parallel_for_each(ranges.size(), [&](std::size_t f) {
    DepthRange& range = ranges[f];
    for (const ClippedCorner& corner : scene.polygon(FacetId(f))) {
      const DepthRange here = range_of(forms.depth_at(rounded_once(position_of(scene, corner))));
      range.nearest = std::min(range.nearest, here.nearest);
      range.farthest = std::max(range.farthest, here.farthest);
    }
  });
  return ranges;
}

}  // namespace sightline::inline sweep
