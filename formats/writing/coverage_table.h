// coverage.csv: what cameras and panels cover, each for itself and together (coverage/coverage.h).
//
// A row's face, camera and panel say what it is about; an empty field means all of them. The first rows are of all
// faces: each camera with each panel, each camera, each panel, everything. Then everything follows per face, in file
// order, index from 0. visible_area is that of the camera or cameras, whatever the panel is. Shares are of the
// surface's area, or of the face's; they are 0 where that has no area. Without panels nothing reflects. Names are
// as csv_name.h has them. Where only some faces count (coverage.h), the rows of all faces are of those.
#pragma once

#include <string>

#include "coverage/coverage.h"
#include "geometry/numbers/export.h"

namespace sightline::inline formats {

// `cameras` and `panels` are their names, as many as the coverage has.
[[nodiscard]] SIGHTLINE_EXPORT std::string coverage_table(const Coverage& coverage,
                                                          const std::vector<std::string>& cameras,
                                                          const std::vector<std::string>& panels);

// Returns the share of an area within another one, in [0, 1].
[[nodiscard]] SIGHTLINE_EXPORT double share_of(double part, double whole);

}  // namespace sightline::inline formats
