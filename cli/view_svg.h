// view.svg: the visible polygons with their holes, as the camera sees them.
//
// One path per visible polygon above resolution: id "face-F" ("face-F-2", ... for further polygons of the same face),
// data-face, class front or back. Path coordinates are the window's, [-1, 1]^2 with y up, at full precision; a
// transform turns them into SVG's y-down axes and the window's aspect.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "sightline/analyze.h"

namespace sightline {

// places: window_points(view).
[[nodiscard]] std::string view_svg(const Mesh& mesh, const View& view, const std::vector<Point2>& places);

}  // namespace sightline
