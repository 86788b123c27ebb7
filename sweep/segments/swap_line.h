// The lines of swap edges: by a filter, and exactly.
//
// In:  how near the planes of two surfaces are to the eye (nearness.h).
// Out: the swap edge between them, and on which side of it a place is.
// Method: where both planes are equally near, they meet; so the line is the difference of two forms, and its sign says who is
//      nearer.
// Complexity: O(1), in integers of any size where exact.
// Source: docs/unrounded.md.
#pragma once

#include <optional>

#include "geometry/projection/exact_place.h"
#include "sweep/segments/nearness.h"
#include "sweep/segments/swap_edge.h"

namespace sightline::inline sweep {

// Returns by how much a place is right of the line, in units of the edge's own, up to a radius.
[[nodiscard]] Bounded distance_right_of(const SwapEdge& swap, const CertifiedPlace& place);

// Returns the line itself, of a swap edge that is seen.
[[nodiscard]] ExactLine exact_line(const SwapEdge& swap, ExactNearness& nearness);

namespace swap_edge_tiers {

// Returns nothing where the forms do not decide which way the line runs, or leave too much of it open.
[[nodiscard]] std::optional<SwapEdge> filtered(const Nearness<Bounded>& of_first, const Nearness<Bounded>& of_second);
[[nodiscard]] SwapEdge exact(const Nearness<BigInteger>& of_first, const Nearness<BigInteger>& of_second);

}  // namespace swap_edge_tiers

// Each of four roundings is at most u of the sum's terms, which is at most of `reach`.
inline Bounded distance_right_of(const SwapEdge& swap, const CertifiedPlace& place) {
  const double reach = std::fabs(place.x) + std::fabs(place.y) + 1;
  const double through_place = (std::fabs(swap.a) + std::fabs(swap.b)) * place.radius;
  return {(swap.a * place.x + swap.b * place.y) + swap.c,
          Bounded::widened(through_place + (swap.radius + 4 * unit_roundoff) * (reach + 2 * place.radius))};
}

}  // namespace sightline::inline sweep
