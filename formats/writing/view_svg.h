// view.svg has the visible polygons with their holes, as the camera sees them.
//
// There is one path per visible polygon above resolution: it has the id "face-F" ("face-F-2", ... for further polygons
// of the same face), data-face, class front or back. Path coordinates are the window's, [-1, 1]^2 with y up, at full
// precision; a transform turns them into SVG's y-down axes and the window's aspect. Above them lies a group per panel,
// with class "reflecting" and data-panel, and in it one path per reflecting polygon, with the id "reflecting-PANEL-F",
// numbered likewise, and data-face.
#pragma once

#include <string>
#include <vector>

#include "formats/writing/text_buffer.h"
#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/export.h"
#include "sightline/view.h"

namespace sightline::inline formats {

// `places` are window_points(view). `panels` are the names of all panels; without any there are no layers for them.
SIGHTLINE_EXPORT void write_view_svg(const View& view, const std::vector<Point2>& places,
                                     const std::vector<std::string>& panels, TextBuffer& out);

}  // namespace sightline::inline formats
