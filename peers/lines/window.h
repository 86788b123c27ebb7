// Lines of the image are clipped to this upright window.
#pragma once

#include "geometry/numbers/predicates.h"

namespace sightline::peers {

struct Window {
  double x_min = -1;
  double y_min = -1;
  double x_max = 1;
  double y_max = 1;
};

struct Line {
  Point2 from;
  Point2 to;
};

}  // namespace sightline::peers
