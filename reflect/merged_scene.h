// A view's scene and segments with more lines and places in them.
//
// In:  the projected scene and its visible segments; pieces whose lines and places are known by value (image_place.h).
// Out: both again, with new numbers for points and edges: the lines of the pieces are edges without sides, and the ends
//      of the pieces are points, scene points or crossings; and per piece these numbers. Facets, and the segments'
//      order and ids, stay.
// Holds: what holds for a projected scene and for visible segments, except that an edge may be without sides.
// Complexity: O(n log n).
#pragma once

#include <span>

#include "geometry/projection/projected_scene.h"
#include "reflect/regions/overlay.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline reflect {

struct NumberedPiece {
  PointId start;
  PointId end;
  EdgeId edge;
};

struct MergedScene {
  ProjectedScene scene;
  VisibleSegments segments;
  std::vector<NumberedPiece> pieces;  // parallel to those given
};

[[nodiscard]] MergedScene merge(const ProjectedScene& scene, const VisibleSegments& segments,
                                std::span<const BorderPiece> pieces);

}  // namespace sightline::inline reflect
