#include "sweep/plain/depth_ranges.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/bounded.h"
#include "geometry/numbers/parallel.h"
#include "geometry/projection/camera_forms.h"
#include "sweep/segments/nearness.h"

namespace sightline::inline sweep {
namespace {

// A corner that clipping or cutting made is rounded once.
BoundedVector rounded_once(const Point3& p) {
  return p.unaryExpr([](double c) { return Bounded{c, Bounded::widened(unit_roundoff * std::fabs(c))}; });
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr DepthRange everywhere{-infinity, infinity};

// A depth that overflows is no number, and bounds nothing.
DepthRange range_of(const Bounded& depth) {
  if (!(depth.radius < infinity)) return everywhere;
  return {depth.value - depth.radius, depth.value + depth.radius};
}

DepthRange hull(const DepthRange& a, const DepthRange& b) {
  return {std::min(a.nearest, b.nearest), std::max(a.farthest, b.farthest)};
}

// Returns how deep the plane of the form is where a point is seen (snapped_order.h).
Bounded depth_in_plane(const Nearness<Bounded>& form, Projection projection, const CameraPlace<Bounded>& seen) {
  const Bounded at_place = form.a * seen.x + form.b * seen.y + form.c * seen.w;
  return projection == Projection::perspective ? seen.depth * form.k / at_place : -(at_place / form.k);
}

// Returns the depths of what is in view of a facet that counts as in another one's plane.
DepthRange range_of_snapped(const ProjectedScene& scene, const CameraForms<Bounded>& forms, FacetId f) {
  const auto form = bounded_nearness(scene, f);
  if (!form) return everywhere;
  DepthRange range;
  for (const ClippedCorner& corner : scene.polygon(f))
    range = hull(range, range_of(depth_in_plane(*form, scene.camera.projection,
                                                forms.at(rounded_once(position_of(scene, corner))))));
  return range;
}

}  // namespace

std::vector<DepthRange> depth_ranges(const ProjectedScene& scene) {
  std::vector<DepthRange> ranges(scene.status.size());
  const CameraForms<Bounded> forms(scene.camera);
  parallel_for_each(ranges.size(), [&](std::size_t f) {
    if (scene.mesh().is_snapped(scene.mesh().uncut_facet(FacetId(f)))) {
      ranges[f] = range_of_snapped(scene, forms, FacetId(f));
      return;
    }
    for (const ClippedCorner& corner : scene.polygon(FacetId(f)))
      ranges[f] = hull(ranges[f], range_of(forms.depth_at(rounded_once(position_of(scene, corner)))));
  });
  return ranges;
}

}  // namespace sightline::inline sweep
