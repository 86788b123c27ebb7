// The places of a view's points in the window, for the writers: computed once, since each crossing costs wide integers.
//
// Out: per point (scene points, then crossings) its x and y in [-1, 1], the exact value rounded to double.
#pragma once

#include <vector>

#include "geometry/numbers/export.h"
#include "sightline/analyze.h"

namespace sightline::inline formats {

[[nodiscard]] SIGHTLINE_EXPORT std::vector<Point2> window_points(const View& view);

// Of a point that the camera sees, in floating point.
[[nodiscard]] SIGHTLINE_EXPORT Point2 window_place(const Camera& camera, const Point3& p);

}  // namespace sightline::inline formats
