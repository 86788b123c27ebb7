#include "sweep/plain/depth_ranges.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/parallel.h"
#include "geometry/numbers/rounding.h"

namespace sightline::inline sweep {
namespace {

// forward . (p - origin): a corner that clipping or cutting made is rounded once (1 u of its coordinates), the difference once, the
// product once, and the sums twice: 5 u of the absolute values, and 8 u covers the roundings of the bound. An underflow
// costs less than 2^-1000.
struct Depth {
  double value = 0;
  double error = 0;
};

constexpr double depth_bound = 8 * unit_roundoff;
static_assert(depth_bound >= (5 + 16 * unit_roundoff) * unit_roundoff * (1 + 8 * unit_roundoff));

Depth depth_of(const Camera& camera, const Point3& p) {
  Depth depth;
  double sum = 0;
  const auto add = [&](double factor, double coordinate, double origin) {
    depth.value += factor * (coordinate - origin);
    sum += std::fabs(factor) * (std::fabs(coordinate) + std::fabs(origin));
  };
  add(camera.forward.x(), p.x(), camera.origin.x());
  add(camera.forward.y(), p.y(), camera.origin.y());
  add(camera.forward.z(), p.z(), camera.origin.z());
  depth.error = depth_bound * sum + 0x1p-1000;
  return depth;
}

// A depth that overflows is no number, and bounds nothing.
DepthRange range_of(const Depth& depth) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(depth.error < infinity)) return {-infinity, infinity};
  return {depth.value - depth.error, depth.value + depth.error};
}

}  // namespace

std::vector<DepthRange> depth_ranges(const Mesh& mesh, const ProjectedScene& scene) {
  std::vector<DepthRange> ranges(scene.status.size());
  parallel_for_each(ranges.size(), [&](std::size_t f) {
    DepthRange& range = ranges[f];
    for (const ClippedCorner& corner : scene.polygon(FacetId(f))) {
      const DepthRange here = range_of(depth_of(scene.camera, position_of(mesh, scene, corner)));
      range.nearest = std::min(range.nearest, here.nearest);
      range.farthest = std::max(range.farthest, here.farthest);
    }
  });
  return ranges;
}

}  // namespace sightline::inline sweep
