// view.svg: the visible polygons with their holes, as the camera sees them.
//
// One path per visible polygon above resolution: id "face-F" ("face-F-2", ... for further polygons of the same face),
// data-face, class front or back. Path coordinates are the window's, [-1, 1]^2 with y up, at full precision; a
// transform turns them into SVG's y-down axes and the window's aspect. Above them a group per panel: class "reflecting",
// data-panel, with one path per reflecting polygon: id "reflecting-PANEL-F", numbered likewise, and data-face.
#pragma once

#include <string>
#include <vector>

#include "formats/writing/text_buffer.h"
#include "geometry/mesh/mesh.h"
#include "geometry/numbers/export.h"
#include "sightline/analyze.h"

namespace sightline::inline formats {

// places: window_points(view). panels: the names of all panels; none: without their layers.
SIGHTLINE_EXPORT void write_view_svg(const Mesh& mesh, const View& view, const std::vector<Point2>& places,
                                     const std::vector<std::string>& panels, TextBuffer& out);

}  // namespace sightline::inline formats
