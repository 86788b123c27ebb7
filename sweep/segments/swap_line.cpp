#include "sweep/segments/swap_line.h"

#include <algorithm>

namespace sightline::inline sweep {
namespace {

// Lines that are known less well are worked out exactly, and rounded.
constexpr double largest_line_radius = 0x1p-44;

// Of numbers with bounds, or of integers.
template <class Number>
std::array<Number, 3> difference(const Nearness<Number>& f, const Nearness<Number>& g) {
  return {f.a * g.k - g.a * f.k, f.b * g.k - g.b * f.k, f.c * g.k - g.c * f.k};
}

// A line runs down where a > 0, and a horizontal one to the right where b > 0.
bool runs_down(const std::array<BigInteger, 3>& line) { return line[0] > 0 || (line[0] == 0 && line[1] > 0); }

}  // namespace

ExactLine exact_line(const SwapEdge& swap, ExactNearness& nearness) {
  auto [a, b, c] = difference(nearness.of(swap.surfaces[0]), nearness.of(swap.surfaces[1]));
  if (swap.first_nearer > 0) return {std::move(a), std::move(b), std::move(c)};
  return {-a, -b, -c};
}

namespace swap_edge_tiers {

// All is divided by the largest coefficient as it was computed, so that this is 1.
std::optional<SwapEdge> filtered(const Nearness<Bounded>& of_first, const Nearness<Bounded>& of_second) {
  const auto line = difference(of_first, of_second);
  if (!line[0].is_positive() && !line[0].is_negative()) return std::nullopt;
  const Sign down = line[0].is_positive() ? 1 : -1;
  const double largest = std::max({std::fabs(line[0].value), std::fabs(line[1].value), std::fabs(line[2].value)});
  const auto share = [&](const Bounded& coefficient) { return coefficient / Bounded(down * largest); };
  const std::array<Bounded, 3> shares{share(line[0]), share(line[1]), share(line[2])};
  const double radius = std::max({shares[0].radius, shares[1].radius, shares[2].radius});
  if (!(radius <= largest_line_radius)) return std::nullopt;
  return SwapEdge{{}, shares[0].value, shares[1].value, shares[2].value, radius, down};
}

SwapEdge exact(const Nearness<BigInteger>& of_first, const Nearness<BigInteger>& of_second) {
  const auto line = difference(of_first, of_second);
  if (line[0] == 0 && line[1] == 0) return {{}, 0, 0, 1, 0, sign_of(line[2]), false};
  const Sign down = runs_down(line) ? 1 : -1;
  const BigInteger largest = std::max({BigInteger(abs(line[0])), BigInteger(abs(line[1])), BigInteger(abs(line[2]))});
  const auto share = [&](const BigInteger& coefficient) { return down * rounded_quotient(coefficient, largest); };
  return {{}, share(line[0]), share(line[1]), share(line[2]), unit_roundoff, down};
}

}  // namespace swap_edge_tiers
}  // namespace sightline::inline sweep
