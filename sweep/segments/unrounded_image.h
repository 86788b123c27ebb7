// Where the points and edges of an image lie to each other whose points are not rounded.
//
// In:  an unrounded scene, and swap edges, whose ids follow those of the scene's edges; there may be more of them later.
// Out: signs and orders, exact; places with the radius by which they may be off.
// Method: a filter in double, with the proven radius of each place, decides nearly all. Where bits are missing, double words
//      have them (seen_in_space.h); zeros that names say take no arithmetic (crossing_names.h; a point that ends an edge is on it
//      by its number). Behind them stand integers of any size: a vertex is (x, y, w), the line of an edge the cross product of its
//      ends, a crossing the cross product of two lines. Sides and turns that they decided are remembered, but for sides of
//      crossings.
// Derivation of the filters, with u = 2^-53. A difference of two places is off by the sum r of their radii, and rounds: by u
// of itself. Let d and e be two such ways with radii r and s in each coordinate. Their determinant d.x e.y - d.y e.x is off
// by at most r |e| + s |d| + 2 r s, where |.| adds up both coordinates, and by its own three roundings: less than
// 3 u (|d.x e.y| + |d.y e.x|). What these bounds round themselves `widened` covers (bounded.h).
// For several threads at once. Complexity: O(1) each.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "geometry/projection/certain_height.h"
#include "sweep/segments/crossing_names.h"
#include "sweep/segments/seen_in_space.h"

namespace sightline::inline sweep {

// How often something was asked, and how often integers had to answer.
struct UnroundedCounts {
  std::uint64_t sides = 0, exact_sides = 0;
  std::uint64_t turns = 0, exact_turns = 0;
  std::uint64_t exact_orders = 0;
};

class UnroundedImage {
 public:
  // The place where two edges cross.
  struct Place {
    EdgeId a;
    EdgeId b;
  };

  // Both outlive it.
  UnroundedImage(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges);

  // Prepares for many questions about edges, in O(n).
  void expect_many_questions();

  [[nodiscard]] bool is_swap_edge(EdgeId e) const { return e.index() >= edge_count_; }
  [[nodiscard]] const SwapEdge& swap_edge(EdgeId e) const { return swap_edges_[e.index() - edge_count_]; }

  // Returns +1 where, below a common point, a lies left of b; 0 where they lie on each other.
  [[nodiscard]] Sign turn(EdgeId a, EdgeId b) const;
  // Returns +1 where the point is right of the edge, 0 where it is on it.
  [[nodiscard]] Sign side(EdgeId e, PointId p) const;
  [[nodiscard]] Sign side(EdgeId e, const Place& place) const { return side(e, place, filtered_place(place)); }
  [[nodiscard]] Sign side(EdgeId e, const Place& place, const CertifiedPlace& filtered) const;

  // Returns by how much a place is right of an edge, in units of its own, up to a radius.
  [[nodiscard]] Bounded distance_right_of(EdgeId e, const CertifiedPlace& place) const {
    return is_swap_edge(e) ? sweep::distance_right_of(swap_edge(e), place)
                           : determinant(direction(e), way(top(e), place));
  }

  // A way is a difference of two places, or the direction of a line, of any length.
  struct Way {
    double x = 0;
    double y = 0;
    double radius = 0;
  };
  [[nodiscard]] static Way way(const CertifiedPlace& from, const CertifiedPlace& to);
  [[nodiscard]] Way direction(EdgeId e) const {
    return e.index() < directions_.size() ? directions_[e.index()] : computed_direction(e);
  }
  // Positive where e turns left of d.
  [[nodiscard]] static Bounded determinant(const Way& d, const Way& e);

  // Returns the y of a place with its radius.
  [[nodiscard]] Bounded height(EdgeId a, EdgeId b) const;
  [[nodiscard]] Bounded height(PointId p) const { return height_of(certified(p)); }

  // These compare in sweep order: -1 where the first comes first, 0 where they are one place.
  [[nodiscard]] int compare(const Place& a, PointId p) const;
  [[nodiscard]] int compare(const Place& a, const Place& b) const;

  [[nodiscard]] const CertifiedPlace& certified(PointId p) const { return scene_.unrounded.places[p.index()]; }
  // Returns the place with at most the largest radius that a place may have (exact_place.h).
  [[nodiscard]] CertifiedPlace certified(const Place& place) const;
  // Returns the place as the filters know it, whatever its radius is.
  [[nodiscard]] CertifiedPlace filtered_place(const Place& crossing) const;
  // Returns the place with each coordinate rounded once; nothing where the bounds leave that open.
  [[nodiscard]] std::optional<Point2> rounded(const Place& place) const;

  [[nodiscard]] ExactPlace exact(PointId p) const;
  [[nodiscard]] ExactPlace exact(const Place& place) const;
  [[nodiscard]] ExactLine exact_line(EdgeId e) const;

  [[nodiscard]] UnroundedCounts counts() const;

 private:
  // What integers found out, kept behind a lock. No result depends on its order: it is only looked up.
  struct Memory {
    Memory(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges)
        : corners(scene.camera), nearness(scene), names(scene, swap_edges, nearness) {}

    std::mutex lock;
    ExactCorners corners;
    ExactNearness nearness;
    CrossingNames names;
    std::unordered_map<std::uint32_t, ExactPlace> places;  // per point
    std::unordered_map<std::uint32_t, ExactLine> lines;    // per edge
    std::unordered_map<std::uint64_t, Sign> sides, turns;
    std::unordered_map<std::uint64_t, CertifiedPlace> crossings;  // two edges are one number
    std::unordered_map<std::uint64_t, ExactPlace> meetings;
    UnroundedCounts counts;
  };

  [[nodiscard]] static double size(double x, double y) { return std::fabs(x) + std::fabs(y); }
  [[nodiscard]] const SceneEdge& edge(EdgeId e) const { return scene_.edges[e.index()]; }
  [[nodiscard]] const CertifiedPlace& top(EdgeId e) const { return certified(edge(e).top); }
  [[nodiscard]] Way computed_direction(EdgeId e) const;
  [[nodiscard]] Bounded share_along(EdgeId a, EdgeId b) const;
  [[nodiscard]] static CertifiedPlace place_on_swaps(const SwapEdge& p, const SwapEdge& q);
  [[nodiscard]] Bounded share_to_swap(EdgeId e, EdgeId swap) const;
  [[nodiscard]] int compare_in_words(const Place& a, const Place& b) const;
  [[nodiscard]] int compare_along(EdgeId e, EdgeId with_a, EdgeId with_b) const;
  [[nodiscard]] Sign exact_side(EdgeId e, PointId p) const;
  [[nodiscard]] Sign exact_turn(EdgeId a, EdgeId b) const;

  // These are called with the lock held.
  [[nodiscard]] const ExactPlace& known_exact(PointId p) const;
  [[nodiscard]] const ExactLine& line(EdgeId e) const;
  [[nodiscard]] const ExactPlace& meeting(const Place& place) const;

  const ProjectedScene& scene_;
  const std::size_t edge_count_;
  const std::vector<SwapEdge>& swap_edges_;
  const SeenInSpace space_;
  std::vector<Way> directions_;  // per edge of the scene, or empty
  const std::unique_ptr<Memory> memory_;
};

// Small functions that the sweep asks all the time are inline.

inline UnroundedImage::Way UnroundedImage::way(const CertifiedPlace& from, const CertifiedPlace& to) {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  return {x, y, Bounded::widened(from.radius + to.radius + unit_roundoff * std::max(std::fabs(x), std::fabs(y)))};
}

inline Bounded UnroundedImage::determinant(const Way& d, const Way& e) {
  const double left = d.x * e.y;
  const double right = d.y * e.x;
  const double through = d.radius * size(e.x, e.y) + e.radius * size(d.x, d.y) + 2 * d.radius * e.radius;
  return {left - right, Bounded::widened(Bounded::widened(through) + 3 * unit_roundoff * size(left, right))};
}

inline Sign UnroundedImage::side(EdgeId e, PointId p) const {
  if (is_swap_edge(e)) {
    const auto sign = certain_sign(sweep::distance_right_of(swap_edge(e), certified(p)));
    return sign ? *sign : exact_side(e, p);
  }
  if (p == edge(e).top || p == edge(e).bottom) return 0;
  const auto sign = certain_sign(determinant(direction(e), way(top(e), certified(p))));
  return sign ? *sign : exact_side(e, p);
}

inline Sign UnroundedImage::turn(EdgeId a, EdgeId b) const {
  if (a == b) return 0;
  const auto sign = certain_sign(determinant(direction(a), direction(b)));
  return sign ? *sign : exact_turn(a, b);
}

}  // namespace sightline::inline sweep
