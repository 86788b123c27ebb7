// What the sweep asks of the image where nothing is rounded (decider.h).
//
// A filter in double, with the proven radius of each place, decides nearly all. Behind it stand integers of any size: a
// vertex is (x, y, w), the line of an edge the cross product of its ends, a crossing the cross product of two lines. A point
// that ends an edge is on it by its number, without arithmetic; sides and turns that integers decided are remembered, but for
// sides of crossings.
//
// Derivation of the filters, with u = 2^-53. A difference of two places is off by the sum r of their radii, and rounds: by u
// of itself. Let d and e be two such ways with radii r and s in each coordinate. Their determinant d.x e.y - d.y e.x is off
// by at most r |e| + s |d| + 2 r s, where |.| adds up both coordinates, and by its own three roundings: less than
// 3 u (|d.x e.y| + |d.y e.x|). What these bounds round themselves `widened` covers (bounded.h).
// Not for several threads at once.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <unordered_map>
#include <vector>

#include "geometry/numbers/bounded.h"
#include "sweep/segments/edge_turns.h"
#include "sweep/unrounded/swap_edges.h"

namespace sightline::inline sweep {

class Swaps;

// How often something was asked, and how often integers had to answer.
struct UnroundedCounts {
  std::uint64_t sides = 0, exact_sides = 0;
  std::uint64_t turns = 0, exact_turns = 0;
  std::uint64_t exact_orders = 0;
};

class UnroundedDecider final : public EdgeTurns {
 public:
  static constexpr bool is_exact = true;
  using Swaps = sweep::Swaps;
  using Height = Bounded;
  // The place where two edges cross.
  struct Place {
    EdgeId a;
    EdgeId b;
  };

  explicit UnroundedDecider(const UnroundedScene& scene);

  [[nodiscard]] Sign turn(EdgeId a, EdgeId b) const override;
  [[nodiscard]] Sign side(EdgeId e, PointId p) const;
  [[nodiscard]] Sign side(EdgeId e, const Place& place) const;

  [[nodiscard]] static Place place(EdgeId a, EdgeId b) { return {a, b}; }
  [[nodiscard]] Height height(EdgeId a, EdgeId b) const;
  [[nodiscard]] Height height(PointId p) const { return {scene_.places[p.index()].y, scene_.places[p.index()].radius}; }
  [[nodiscard]] static int compare_heights(const Height& a, const Height& b) {
    const double apart = b.value - a.value;
    const double reach = Bounded::widened(a.radius + b.radius + unit_roundoff * std::fabs(apart));
    return apart > reach ? 1 : apart < -reach ? -1 : 0;
  }
  [[nodiscard]] int compare(const Place& a, PointId p) const;
  [[nodiscard]] int compare(const Place& a, const Place& b) const;
  [[nodiscard]] static bool is_number(const Place& /*place*/) { return true; }

  [[nodiscard]] std::array<double, 2> in_window(PointId p) const;
  [[nodiscard]] std::array<double, 2> in_window(const Place& place) const;

  [[nodiscard]] bool is_swap_edge(EdgeId e) const { return swap_edges_.is_one(e); }
  [[nodiscard]] std::array<FacetId, 2> surfaces_of_swap_edge(EdgeId e) const { return swap_edges_[e].surfaces; }
  [[nodiscard]] EdgeId swap_edge(FacetId f, FacetId g) const;
  // Returns false where the image does not show the line (swap_edges.h).
  [[nodiscard]] bool is_seen(EdgeId swap_edge) const { return swap_edges_[swap_edge].is_seen; }
  [[nodiscard]] Sign nearer_side(EdgeId swap_edge, FacetId f) const { return swap_edges_.nearer_side(swap_edge, f); }

  // Returns places with the radius by which they may be off.
  [[nodiscard]] const CertifiedPlace& certified(PointId p) const { return scene_.places[p.index()]; }
  [[nodiscard]] const CertifiedPlace& certified(const Place& place) const { return certified_place(place); }

  [[nodiscard]] ExactPlace exact(PointId p) const { return known_exact(p); }
  [[nodiscard]] ExactPlace exact(const Place& place) const { return meeting_place(line(place.a), line(place.b)); }
  [[nodiscard]] const UnroundedCounts& counts() const { return counts_; }

 private:
  // A way is a difference of two places, or the direction of a swap edge, of any length.
  struct Way {
    double x = 0;
    double y = 0;
    double radius = 0;
  };

  [[nodiscard]] static Way way(const CertifiedPlace& from, const CertifiedPlace& to);
  [[nodiscard]] static Bounded determinant(const Way& d, const Way& e);
  [[nodiscard]] Bounded share_along(EdgeId a, EdgeId b) const;
  [[nodiscard]] CertifiedPlace filtered_place(const Place& place) const;
  [[nodiscard]] const CertifiedPlace& certified_place(const Place& place) const;
  [[nodiscard]] Bounded swap_side(EdgeId e, const CertifiedPlace& place) const;
  [[nodiscard]] const ExactPlace& known_exact(PointId p) const;
  [[nodiscard]] const ExactLine& line(EdgeId e) const;
  [[nodiscard]] Sign exact_side(EdgeId e, PointId p) const;
  [[nodiscard]] Sign exact_turn(EdgeId a, EdgeId b) const;

  const UnroundedScene& scene_;
  mutable SwapEdges swap_edges_;
  mutable std::vector<Way> directions_;  // per edge, and then per swap edge

  // These are remembered, and only looked up: no result depends on their order.
  mutable std::vector<std::unique_ptr<ExactPlace>> exact_places_;  // per point
  mutable std::vector<std::unique_ptr<ExactLine>> lines_;          // per edge
  mutable std::unordered_map<std::uint64_t, Sign> sides_, turns_;
  mutable std::unordered_map<std::uint64_t, CertifiedPlace> crossings_;
  mutable UnroundedCounts counts_;
};

}  // namespace sightline::inline sweep
