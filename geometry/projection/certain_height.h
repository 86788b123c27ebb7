// Heights of places that are known up to a radius.
#pragma once

#include "geometry/numbers/bounded.h"
#include "geometry/projection/exact_place.h"

namespace sightline::inline geometry {

[[nodiscard]] inline Bounded height_of(const CertifiedPlace& place) { return {place.y, place.radius}; }

// Returns -1 where the first is certainly higher, and so comes first in sweep order; 0 where that is open.
[[nodiscard]] inline int compare_heights(const Bounded& a, const Bounded& b) {
  const double apart = b.value - a.value;
  const double reach = Bounded::widened(a.radius + b.radius + unit_roundoff * std::fabs(apart));
  return apart > reach ? 1 : apart < -reach ? -1 : 0;
}

}  // namespace sightline::inline geometry
