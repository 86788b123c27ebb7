// The errors say how far what a peer says of areas is from what is exactly visible.
//
// Areas are integrated, not sampled: each pixel of an item buffer counts with the part of it that the exact visible
// polygons give to another face; visible parts are cut with the exact polygons. Nothing seen is a label, too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "geometry/numbers/ids.h"

namespace sightline::peers {

struct AreaErrors {
  double wrong_share = 0;             // of the window: labelled with the wrong face
  double largest_relative_error = 0;  // of a visible face's area
  double mean_relative_error = 0;
  std::size_t missed_faces = 0;        // visible, and not shown
  std::size_t hidden_faces_shown = 0;  // shown, and not visible
};

// Each face that has any has its area, in window units squared (the window has 4).
using FaceAreas = std::map<FaceId, double>;

// Fills in all but the wrong share.
[[nodiscard]] AreaErrors compare_faces(const FaceAreas& seen, const FaceAreas& exact);

}  // namespace sightline::peers
