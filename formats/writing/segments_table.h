// segments.csv has every visible segment, in the sweep's order.
//
// Columns: face (to the segment's left), start and end in the window [-1, 1]^2 (x right, y up), what it lies on
// ("mesh": an edge of the mesh; "common": a common line of two faces; "border": of the view volume, or of a lens's frame), the face
// that is topmost on its right (empty: none), and the ends of the mesh's edge (vertex indices from 0, welded, smaller first; in two
// columns, as a spreadsheet takes 3-7 for a date).
#pragma once

#include <string>
#include <vector>

#include "formats/writing/text_buffer.h"
#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/export.h"
#include "sightline/view.h"

namespace sightline::inline formats {

// `places` are window_points(view).
SIGHTLINE_EXPORT void write_segments_table(const View& view, const std::vector<Point2>& places, TextBuffer& out);

}  // namespace sightline::inline formats
