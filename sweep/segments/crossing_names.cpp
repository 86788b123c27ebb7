#include "sweep/segments/crossing_names.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline sweep {
namespace {

CrossingNames::Name pair(std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; }

CrossingNames::Name unordered_pair(std::uint32_t a, std::uint32_t b) { return pair(std::min(a, b), std::max(a, b)); }

}  // namespace

// Its edges are then not in the plane.
bool CrossingNames::has_snapped_plane(FacetId facet) const {
  return scene_.mesh().is_snapped(scene_.mesh().uncut_facet(facet));
}

CrossingNames::Name CrossingNames::of(EdgeId a, EdgeId b) {
  Name name = unordered_pair(line_of(a).value, line_of(b).value);
  for (const auto& [e, swap] : {std::pair(a, b), std::pair(b, a)}) {
    if (const auto through = passage(e, swap)) name = passages_.try_emplace(*through, name).first->second;
  }
  return united(name);
}

// Returns one of all surfaces that lie in the same plane.
FacetId CrossingNames::plane_of(FacetId surface) {
  const auto [known, is_new] = planes_.try_emplace(surface.value);
  if (!is_new) return known->second;
  const Nearness<BigInteger>& form = nearness_.of(surface);
  const BigInteger divisor = gcd(gcd(form.a, form.b), gcd(form.c, form.k));
  const std::array<BigInteger, 4> plane{form.a / divisor, form.b / divisor, form.c / divisor, form.k / divisor};
  return known->second = surfaces_in_.try_emplace(plane, surface).first->second;
}

std::array<FacetId, 2> CrossingNames::planes_of(EdgeId swap) {
  const auto& [first, second] = swap_edges_[swap.index() - scene_.edge_count()].surfaces;
  return {plane_of(first), plane_of(second)};
}

// Returns one of all swap edges on the same line; of another edge itself.
EdgeId CrossingNames::line_of(EdgeId e) {
  if (!is_swap_edge(e)) return e;
  const auto [first, second] = planes_of(e);
  return lines_.try_emplace(unordered_pair(first.value, second.value), e).first->second;
}

// Returns a mesh edge in one plane and the other plane, which it passes through, where an edge of the image crosses the swap
// edge of both; nothing where it is an edge in neither.
std::optional<CrossingNames::Name> CrossingNames::passage(EdgeId e, EdgeId swap) {
  if (is_swap_edge(e) || !is_swap_edge(swap)) return std::nullopt;
  const auto [first, second] = planes_of(swap);
  for (const EdgeSide& side : scene_.sides_of(e)) {
    if (!side.mesh_edge.valid() || has_snapped_plane(side.facet)) continue;
    const FacetId plane = plane_of(surface_of(scene_.mesh(), side.facet));
    if (plane == first) return pair(side.mesh_edge.value, second.value);
    if (plane == second) return pair(side.mesh_edge.value, first.value);
  }
  return std::nullopt;
}

// Names that were united lead to one of them; the way there is made shorter as it is gone.
CrossingNames::Name CrossingNames::united(Name name) {
  auto next = united_.find(name);
  while (next != united_.end()) {
    const auto after = united_.find(next->second);
    if (after == united_.end()) return next->second;
    name = next->second = after->second;
    next = united_.find(name);
  }
  return name;
}

}  // namespace sightline::inline sweep
