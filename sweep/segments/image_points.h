// The points of a sweep's result, scene points and crossings alike, are found by id, with exact predicates behind a
// filter.
//
// A crossing is base + offset / denominator, so as a homogeneous point |X|, |Y| <= 2^125 and D <= 2^83
// (crossing_point.h); the orientation of three crossings is a 3 x 3 determinant below 3 * 2^(125 + 125 + 83 + 1) <
// 2^336: 512 bits do.
#pragma once

#include <vector>

#include "geometry/numbers/predicates.h"
#include "sweep/segments/crossing_point.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

class ImagePoints {
 public:
  ImagePoints(const ProjectedScene& scene, const VisibleSegments& segments);

  // The place is in grid units; it is exact for scene points, and off by at most crossing_error for crossings.
  [[nodiscard]] Point2 approximate(PointId p) const {
    const std::size_t vertices = scene_->points.size();
    if (p.index() >= vertices) return {crossings_[p.index() - vertices].x, crossings_[p.index() - vertices].y};
    return {static_cast<double>(scene_->point(p).x), static_cast<double>(scene_->point(p).y)};
  }
  // Returns the exact place, rounded once, in the window's units.
  [[nodiscard]] Point2 in_window(PointId p) const;
  [[nodiscard]] ExactPoint exact(PointId p) const;

  // Returns +1 where a, b, c turn counter-clockwise.
  [[nodiscard]] Sign orientation(PointId a, PointId b, PointId c) const;

  [[nodiscard]] bool sweeps_before(PointId a, PointId b) const { return order_(a, b); }

 private:
  const ProjectedScene* scene_;
  SweepOrder order_;
  std::vector<CrossingPoint> crossings_;
};

}  // namespace sightline::inline sweep
