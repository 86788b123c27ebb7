// Where points, lines and segments of a sweep's result lie to each other, exactly, as the sweep line meets them.
//
// In:  a projected scene and the segments found in it; every id in range, every crossing one of two edges that cross.
// Out: signs and orders. Left and right are those of an edge looked at from the front, as in the active edge list:
//      the sweep line crosses edges from left to right.
// Complexity: O(1) each.
#pragma once

#include "sweep/segments/image_points.h"

namespace sightline::inline sweep {

// A swept line has a direction that follows the sweep.
struct SweptLine {
  PointId top;
  PointId bottom;
};

class EdgeSides {
 public:
  EdgeSides(const ProjectedScene& scene, const VisibleSegments& segments)
      : scene_(&scene), segments_(&segments), points_(scene, segments) {}

  [[nodiscard]] const ImagePoints& points() const { return points_; }
  [[nodiscard]] bool before(PointId a, PointId b) const { return points_.sweeps_before(a, b); }
  [[nodiscard]] SweptLine line(EdgeId e) const { return {scene_->edge(e).top, scene_->edge(e).bottom}; }

  // Returns +1 where p is right of the line, 0 where it is on it.
  [[nodiscard]] Sign side(const SweptLine& line, PointId p) const {
    return is_made_by(line, p) ? 0 : points_.orientation(line.top, line.bottom, p);
  }

  // Returns +1 where, below a common point, a lies left of b; 0 where they are parallel.
  [[nodiscard]] Sign turn(const SweptLine& a, const SweptLine& b) const {
    const ImagePoint u = direction(a);
    const ImagePoint v = direction(b);
    return sign_of(static_cast<Int128>(u.x) * v.y - static_cast<Int128>(u.y) * v.x);
  }

  // `along` passes through p. Just below p the sweep line meets `line` left of `along` (-1), on it (0) or right of it
  // (+1). Precondition: crosses_below(line, p).
  [[nodiscard]] Sign place_beside(const SweptLine& line, PointId p, const SweptLine& along) const {
    const Sign at_point = side(line, p);
    return -(at_point != 0 ? at_point : turn(line, along));
  }
  [[nodiscard]] bool crosses_below(const SweptLine& line, PointId p) const {
    return !before(p, line.top) && before(p, line.bottom);
  }

  [[nodiscard]] bool runs_down(const VisibleSegment& s) const { return before(s.start, s.end); }
  [[nodiscard]] PointId upper(const VisibleSegment& s) const { return runs_down(s) ? s.start : s.end; }
  [[nodiscard]] PointId lower(const VisibleSegment& s) const { return runs_down(s) ? s.end : s.start; }

 private:
  [[nodiscard]] ImagePoint direction(const SweptLine& line) const {
    const ImagePoint& top = scene_->point(line.top);
    const ImagePoint& bottom = scene_->point(line.bottom);
    return {bottom.x - top.x, bottom.y - top.y};
  }

  // Returns whether p is a crossing on an edge between the line's ends: then it is on it, without arithmetic.
  [[nodiscard]] bool is_made_by(const SweptLine& line, PointId p) const {
    if (p.index() < scene_->points.size()) return false;
    const Crossing& crossing = segments_->crossings[p.index() - scene_->points.size()];
    const auto equals = [&](EdgeId e) {
      return scene_->edge(e).top == line.top && scene_->edge(e).bottom == line.bottom;
    };
    return equals(crossing.a) || equals(crossing.b);
  }

  const ProjectedScene* scene_;
  const VisibleSegments* segments_;
  ImagePoints points_;
};

}  // namespace sightline::inline sweep
