// Visible parts in pixels: for pictures.
//
// Complexity: O(pixels + per face those of the rectangle around it).
#pragma once

#include <vector>

#include "peers/scene/seen.h"

namespace sightline::peers {

// Each pixel shows the face that has most of it, or none where no face has half of it.
[[nodiscard]] ItemBuffer in_pixels(const VisibleParts& parts, int resolution);

// Returns, per pixel, row by row, the part that the two have differently.
[[nodiscard]] std::vector<float> difference_in_pixels(const VisibleParts& seen, const VisibleParts& exact,
                                                      int resolution);

}  // namespace sightline::peers
