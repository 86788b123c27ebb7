// Exact sides in the image, for cells: of edges of facets against points of the scene, and against centres of cells.
//
// In:  a projected scene that outlives it.
// Out: signs. On the grid all are integers; where nothing is rounded a filter decides, and exact places behind it.
// Complexity: O(1) each. For several threads at once.
#pragma once

#include "sweep/segments/image_points.h"

namespace sightline::inline sweep {

class CellSides {
 public:
  explicit CellSides(const ProjectedScene& scene) : scene_(scene), points_(scene, no_segments_) {}
  CellSides(const CellSides&) = delete;
  CellSides& operator=(const CellSides&) = delete;

  // Return +1 where they turn counter-clockwise.
  [[nodiscard]] Sign orientation(PointId a, PointId b, PointId c) const {
    if (scene_.is_unrounded()) return points_.orientation(a, b, c);
    return sightline::orientation(scene_.point(a), scene_.point(b), scene_.point(c));
  }
  [[nodiscard]] Sign orientation(PointId a, PointId b, const ImagePoint& centre) const {
    if (scene_.is_unrounded()) return unrounded_orientation(a, b, centre);
    return sightline::orientation(scene_.point(a), scene_.point(b), centre);
  }

  // Returns whether an edge runs along the window's border. What it belongs to does not end there for a cell.
  [[nodiscard]] bool is_on_border(PointId a, PointId b) const;

 private:
  [[nodiscard]] Sign unrounded_orientation(PointId a, PointId b, const ImagePoint& centre) const;

  const ProjectedScene& scene_;
  const VisibleSegments no_segments_;
  const ImagePoints points_;
};

}  // namespace sightline::inline sweep
