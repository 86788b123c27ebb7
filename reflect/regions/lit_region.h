// The lit region is what of a panel's image in the mirror no obstacle hides.
//
// In:  convex polygons of the image (but for rounding): the panel's, and the shadows: the images of what is between the
//      mirror and the panel.
// Out: the border of what is lit, in directed segments: a place is lit where they wind around it more than zero times.
// Method: which obstacle is nearer is of no interest, only that all are before the panel. So the polygons become sheets
// of paper, the shadows above the panel, looked at straight down, and the sweep of the surface itself finds what is
// seen of the panel. Their coordinates are integers, so that nothing is rounded again.
// Complexity: that of the sweep; without shadows O(n).
#pragma once

#include <vector>

#include "geometry/projection/projected_scene.h"
#include "reflect/regions/overlay.h"
#include "reflect/regions/sheets.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline reflect {

[[nodiscard]] RegionBorder lit_region(const std::vector<ImagePolygon>& panel, const std::vector<ImagePolygon>& shadows,
                                      int grid_bits);

[[nodiscard]] BorderSegment border_segment(const ImagePoint& start, const ImagePoint& end);

// The image outlives what is made of it where it is not rounded (image_place.h).
[[nodiscard]] BorderSegment border_segment(const ImagePoints& image, const VisibleSegment& segment);

}  // namespace sightline::inline reflect
