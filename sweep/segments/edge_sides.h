// Where points, edges and segments of a sweep's result lie to each other, exactly, as the sweep line meets them.
//
// In:  a projected scene and the segments found in it; every id in range, every crossing one of two edges that cross.
// Out: signs and orders. Left and right are those of an edge looked at from the front, as in the active edge list:
//      the sweep line crosses edges from left to right.
// Complexity: O(1) each, but for edge_between, O(log n).
#pragma once

#include <algorithm>
#include <array>

#include "sweep/segments/image_points.h"

namespace sightline::inline sweep {

class EdgeSides {
 public:
  EdgeSides(const ProjectedScene& scene, const VisibleSegments& segments) : scene_(&scene), points_(scene, segments) {}

  [[nodiscard]] const ImagePoints& points() const { return points_; }
  [[nodiscard]] bool before(PointId a, PointId b) const { return points_.sweeps_before(a, b); }
  [[nodiscard]] bool is_swap_edge(EdgeId e) const { return e.index() >= scene_->edge_count(); }

  // Returns +1 where p is right of the edge's line, 0 where it is on it.
  [[nodiscard]] Sign side(EdgeId e, PointId p) const { return points_.side(e, p); }

  // Returns +1 where, below a common point, a lies left of b; 0 where they are parallel.
  [[nodiscard]] Sign turn(EdgeId a, EdgeId b) const { return points_.turn(a, b); }

  // `along` passes through p. Just below p the sweep line meets edge e left of `along` (-1), on it (0) or right of it
  // (+1). Precondition: crosses_below(e, p).
  [[nodiscard]] Sign place_beside(EdgeId e, PointId p, EdgeId along) const {
    const Sign at_point = side(e, p);
    return -(at_point != 0 ? at_point : turn(e, along));
  }
  [[nodiscard]] bool crosses_below(EdgeId e, PointId p) const {
    return is_swap_edge(e) || (!before(p, scene_->edge(e).top) && before(p, scene_->edge(e).bottom));
  }

  // Returns whether p is on the edge, its ends included.
  [[nodiscard]] bool is_on(EdgeId e, PointId p) const {
    if (side(e, p) != 0) return false;
    return is_swap_edge(e) || (!before(p, scene_->edge(e).top) && !before(scene_->edge(e).bottom, p));
  }

  // Returns the scene's edge with these ends, upper end first. Precondition: there is one.
  [[nodiscard]] EdgeId edge_between(PointId top, PointId bottom) const {
    const auto& edges = scene_->edges;
    const auto ends = [](const SceneEdge& e) { return std::array{e.top, e.bottom}; };
    const auto end = edges.begin() + static_cast<std::ptrdiff_t>(scene_->edge_count());
    const auto found = std::ranges::lower_bound(edges.begin(), end, std::array{top, bottom}, {}, ends);
    return EdgeId(static_cast<std::size_t>(found - edges.begin()));
  }

  [[nodiscard]] bool runs_down(const VisibleSegment& s) const { return before(s.start, s.end); }
  [[nodiscard]] PointId upper(const VisibleSegment& s) const { return runs_down(s) ? s.start : s.end; }
  [[nodiscard]] PointId lower(const VisibleSegment& s) const { return runs_down(s) ? s.end : s.start; }

 private:
  const ProjectedScene* scene_;
  ImagePoints points_;
};

}  // namespace sightline::inline sweep
