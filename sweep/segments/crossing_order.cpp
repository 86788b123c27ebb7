#include "sweep/segments/crossing_order.h"

#include "sweep/segments/crossing_point.h"

namespace sightline::inline sweep {
namespace {

UnroundedImage::Place place_of(const Crossing& crossing) { return {crossing.a, crossing.b}; }

}  // namespace

CrossingOrder::CrossingOrder(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges)
    : scene_(scene), unrounded_(scene.is_unrounded() ? std::make_unique<UnroundedImage>(scene, swap_edges) : nullptr) {}

int CrossingOrder::compare(const Crossing& crossing, PointId scene_point) const {
  if (unrounded_) return unrounded_->compare(place_of(crossing), scene_point);
  return sweep_compare(crossing_point(scene_, crossing.a, crossing.b), scene_.point(scene_point));
}

int CrossingOrder::compare(const Crossing& a, const Crossing& b) const {
  if (unrounded_) return unrounded_->compare(place_of(a), place_of(b));
  return sweep_compare(crossing_point(scene_, a.a, a.b), crossing_point(scene_, b.a, b.b));
}

}  // namespace sightline::inline sweep
