// The line of the image along which two surfaces that pass through each other change places, as an edge of the sweep.
//
// Such an edge has no ends and no sides. It runs downwards like an edge of the scene, and its id follows theirs.
// Source: docs/unrounded.md.
#pragma once

#include <array>

#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

struct SwapEdge {
  std::array<FacetId, 2> surfaces;  // smaller id first (facet_plane.h)
  ExactLine line;
  double a = 0, b = 0, c = 0;  // the line with its largest coefficient 1, each off by at most 2^-53
  Sign first_nearer = 0;       // +1 where the first surface is nearer on the right of the line
  // False where the planes meet in the camera's own plane, which the image does not show: then first_nearer is said of all of
  // the image.
  bool is_seen = true;
};

}  // namespace sightline::inline sweep
