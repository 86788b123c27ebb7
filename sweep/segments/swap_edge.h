// The line of the image along which two surfaces that pass through each other change places, as an edge of the sweep.
//
// Such an edge has no ends and no sides. It runs downwards like an edge of the scene, and its id follows theirs. Where both
// planes are equally near (nearness.h), they meet; so the line is the difference of two forms, and its sign says who is nearer.
// Source: docs/unrounded.md.
#pragma once

#include <array>

#include "geometry/projection/exact_place.h"
#include "sweep/segments/nearness.h"

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
