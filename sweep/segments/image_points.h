// The points of a sweep's result, scene points and crossings alike, are found by id, with exact predicates on them and on
// edges behind a filter; on the grid, and where nothing is rounded.
//
// On the grid a crossing is base + offset / denominator, so as a homogeneous point |X|, |Y| <= 2^125 and D <= 2^83
// (crossing_point.h); the orientation of three crossings is a 3 x 3 determinant below 3 * 2^(125 + 125 + 83 + 1) <
// 2^336: 512 bits do. What is not rounded is behind unrounded_image.h.
// Complexity: O(k) for k crossings to begin with, and then O(1) each.
#pragma once

#include <memory>
#include <vector>

#include "geometry/numbers/predicates.h"
#include "sweep/segments/crossing_point.h"
#include "sweep/segments/edge_turns.h"
#include "sweep/segments/unrounded_image.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

class ImagePoints final : public EdgeTurns {
 public:
  // Both outlive it, and stay where they are.
  ImagePoints(const ProjectedScene& scene, const VisibleSegments& segments);

  // The place is in grid units; it is exact for scene points, and off by at most crossing_error for crossings.
  // Precondition: the scene is on the grid.
  [[nodiscard]] Point2 approximate(PointId p) const {
    const std::size_t vertices = scene_->points.size();
    if (p.index() >= vertices) return {crossings_[p.index() - vertices].x, crossings_[p.index() - vertices].y};
    return {static_cast<double>(scene_->point(p).x), static_cast<double>(scene_->point(p).y)};
  }
  // Returns the place in the window's units, with the radius by which it may be off.
  [[nodiscard]] CertifiedPlace certified(PointId p) const;
  // Returns the exact place, rounded once, in the window's units.
  [[nodiscard]] Point2 in_window(PointId p) const;
  [[nodiscard]] ExactPlace exact(PointId p) const;

  // Returns +1 where a, b, c turn counter-clockwise.
  [[nodiscard]] Sign orientation(PointId a, PointId b, PointId c) const;
  [[nodiscard]] Sign turn(EdgeId a, EdgeId b) const override;
  // Returns +1 where p is right of the edge, 0 where it is on it; at a crossing of the edge without arithmetic.
  [[nodiscard]] Sign side(EdgeId e, PointId p) const;

  // Returns null where the point is one of the scene's.
  [[nodiscard]] const Crossing* crossing(PointId p) const;
  [[nodiscard]] bool sweeps_before(PointId a, PointId b) const { return order_(a, b); }
  [[nodiscard]] const SweepOrder& order() const { return order_; }
  // Null on the grid.
  [[nodiscard]] const UnroundedImage* unrounded() const { return unrounded_.get(); }
  [[nodiscard]] const ProjectedScene& scene() const { return *scene_; }
  [[nodiscard]] const VisibleSegments& segments() const { return *segments_; }

 private:
  [[nodiscard]] bool is_named_by(EdgeId e, PointId p) const;
  [[nodiscard]] bool are_on_one_edge(PointId a, PointId b, PointId c) const;

  const ProjectedScene* scene_;
  const VisibleSegments* segments_;
  SweepOrder order_;
  std::vector<CrossingPoint> crossings_;       // on the grid
  std::vector<CertifiedPlace> places_;         // of crossings, where nothing is rounded
  std::unique_ptr<UnroundedImage> unrounded_;  // null on the grid
};

// Returns the exact place of one point, in the window's units. ImagePoints is for many.
[[nodiscard]] ExactPlace exact_place(const ProjectedScene& scene, const VisibleSegments& segments, PointId p);

}  // namespace sightline::inline sweep
