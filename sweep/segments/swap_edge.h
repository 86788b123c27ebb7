// The line of the image along which two surfaces that pass through each other change places, as an edge of the sweep.
//
// Such an edge has no ends and no sides. It runs downwards like an edge of the scene, and its id follows theirs.
// Source: docs/unrounded.md.
#pragma once

#include <array>

#include "geometry/numbers/exact_integer.h"
#include "geometry/numbers/ids.h"

namespace sightline::inline sweep {

struct SwapEdge {
  std::array<FacetId, 2> surfaces;  // smaller id first (facet_plane.h)
  double a = 0, b = 0, c = 0;       // a x + b y + c is positive on the right of the line; the largest of them is 1
  double radius = 0;                // by which each coefficient may be off
  Sign first_nearer = 0;            // +1 where the first surface is nearer on the right of the line
  // False where the planes meet in the camera's own plane, which the image does not show: then first_nearer is said of all of
  // the image.
  bool is_seen = true;
};

}  // namespace sightline::inline sweep
