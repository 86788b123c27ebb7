// A view's scene and segments with the borders of regions in them.
//
// In:  the projected scene and its visible segments, which are taken over, or copied where nothing is rounded; a border, whose
//      segments' lines and places are known by value (image_place.h).
// Out: both again, with new numbers for points and edges: the lines of the border are edges without sides, and the ends
//      of its segments are points, scene points or crossings; and per segment of the border these numbers. Facets, and the
//      visible segments' order and ids, stay. Points and edges are numbered anew since their order is the sweep's.
// Holds: what holds for a projected scene and for visible segments, except that an edge may be without sides.
// Complexity: O(n + m log(n + m)) for m segments of the border; nothing where it has none.
#pragma once

#include <span>

#include "geometry/projection/projected_scene.h"
#include "reflect/regions/overlay.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline reflect {

struct NumberedSegment {
  PointId start;
  PointId end;
  EdgeId edge;
};

struct MergedScene {
  ProjectedScene scene;
  VisibleSegments segments;
  std::vector<NumberedSegment> border;  // parallel to the one given
};

[[nodiscard]] MergedScene merge(ProjectedScene scene, VisibleSegments segments, std::span<const BorderSegment> border);

// The same for an image that is not rounded, whose scene and segments are copied.
[[nodiscard]] MergedScene merge(const ImagePoints& image, std::span<const BorderSegment> border);

}  // namespace sightline::inline reflect
