// Which of two edges is left of the other below a common point, whoever knows it: a sweep, or the points of its result.
#pragma once

#include "geometry/numbers/exact_integer.h"
#include "geometry/numbers/ids.h"

namespace sightline::inline sweep {

class EdgeTurns {
 public:
  virtual ~EdgeTurns() = default;

  // Returns +1 where, below a common point, a lies left of b; 0 where they lie on each other.
  [[nodiscard]] virtual Sign turn(EdgeId a, EdgeId b) const = 0;
};

}  // namespace sightline::inline sweep
