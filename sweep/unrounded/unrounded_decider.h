// What the sweep asks of the image where nothing is rounded (decider.h): the image itself, and the swap edges that are found
// while it runs. Not for several threads at once.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "sweep/segments/unrounded_image.h"
#include "sweep/unrounded/swap_edges.h"

namespace sightline::inline sweep {

class Swaps;

class UnroundedDecider {
 public:
  static constexpr bool is_exact = true;
  using Swaps = sweep::Swaps;
  using Height = Bounded;
  using Place = UnroundedImage::Place;

  explicit UnroundedDecider(const ProjectedScene& scene) : swap_edges_(scene), image_(scene, swap_edges_.all()) {
    image_.expect_many_questions();
  }
  UnroundedDecider(const UnroundedDecider&) = delete;
  UnroundedDecider& operator=(const UnroundedDecider&) = delete;

  [[nodiscard]] Sign turn(EdgeId a, EdgeId b) const {
    ++counts_.turns;
    return image_.turn(a, b);
  }
  [[nodiscard]] Sign side(EdgeId e, PointId p) const {
    ++counts_.sides;
    return image_.side(e, p);
  }
  [[nodiscard]] Sign side(EdgeId e, const Place& place) const {
    ++counts_.sides;
    return image_.side(e, place);
  }

  // The same, by somebody who asks often.
  [[nodiscard]] Sign side(EdgeId e, const Place& place, const CertifiedPlace& filtered) const {
    ++counts_.sides;
    return image_.side(e, place, filtered);
  }
  [[nodiscard]] CertifiedPlace filtered_place(const Place& place) const { return image_.filtered_place(place); }

  [[nodiscard]] static Place place(EdgeId a, EdgeId b) { return {a, b}; }
  [[nodiscard]] Height height(EdgeId a, EdgeId b) const { return image_.height(a, b); }
  [[nodiscard]] Height height(PointId p) const { return image_.height(p); }
  [[nodiscard]] static int compare_heights(const Height& a, const Height& b) { return geometry::compare_heights(a, b); }
  [[nodiscard]] int compare(const Place& a, PointId p) const { return image_.compare(a, p); }
  [[nodiscard]] int compare(const Place& a, const Place& b) const { return image_.compare(a, b); }
  [[nodiscard]] static bool is_number(const Place& /*place*/) { return true; }

  template <class Where>
  [[nodiscard]] std::array<double, 2> in_window(const Where& where) const {
    const CertifiedPlace place = image_.certified(where);
    return {place.x, place.y};
  }

  [[nodiscard]] bool is_swap_edge(EdgeId e) const { return image_.is_swap_edge(e); }
  [[nodiscard]] std::array<FacetId, 2> surfaces_of_swap_edge(EdgeId e) const { return image_.swap_edge(e).surfaces; }
  [[nodiscard]] EdgeId swap_edge(FacetId f, FacetId g) const { return swap_edges_.between(f, g); }
  // Returns false where the image does not show the line (swap_edge.h).
  [[nodiscard]] bool is_seen(EdgeId swap_edge) const { return image_.swap_edge(swap_edge).is_seen; }
  [[nodiscard]] Sign nearer_side(EdgeId swap_edge, FacetId f) const { return swap_edges_.nearer_side(swap_edge, f); }
  [[nodiscard]] const std::vector<SwapEdge>& swap_edges() const { return swap_edges_.all(); }

  [[nodiscard]] UnroundedCounts counts() const {
    UnroundedCounts counts = image_.counts();
    counts.sides = counts_.sides;
    counts.turns = counts_.turns;
    return counts;
  }

 private:
  mutable SwapEdges swap_edges_;
  UnroundedImage image_;
  mutable UnroundedCounts counts_;
};

}  // namespace sightline::inline sweep
