// Visible lines are compared as sets of points of the image.
#pragma once

#include "peers/scene/seen.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests {

// Returns the sweep's visible segments without those along the window's border, which are no edges of the mesh. Where
// two faces meet a segment is there twice.
[[nodiscard]] peers::VisibleLines visible_segments(const View& view);

// Returns the length of what the lines have and none of the others has. Others lie on a line where they are within 1e-9
// of it, and gaps of up to 2e-9 do not count.
[[nodiscard]] double uncovered(const peers::VisibleLines& lines, const peers::VisibleLines& others);

}  // namespace sightline::tests
