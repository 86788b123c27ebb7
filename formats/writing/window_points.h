// The places of a view's points in the window, for the writers: computed once, since each crossing costs wide integers.
//
// Out: per point (scene points, then crossings) its x and y in [-1, 1], the exact value rounded to double.
#pragma once

#include <vector>

#include "sightline/view.h"

namespace sightline::inline formats {

[[nodiscard]] std::vector<Point2> window_points(const View& view);

// Returns the place of a point that the camera sees, in floating point.
[[nodiscard]] Point2 window_place(const Camera& camera, const Point3& p);

}  // namespace sightline::inline formats
