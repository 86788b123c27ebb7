// What the sweep asks of the image, by the ids of points and edges.
//
// A decider tells on which side of an edge a point lies, which of two edges is left of the other below a common point, where
// two edges cross, and what comes first in the order of the sweep. The sweep is compiled with one of two:
//   - GridDecider, for points that were rounded to the grid, in one of the arithmetics of image_decisions.h;
//   - UnroundedDecider (sweep/unrounded), for points that are where they are.
// With the first, facets that pass through each other have been cut, and no two ever change places (NoSwaps). With the
// second they do, along swap edges (sweep/unrounded/swaps.h): edges without ends, whose ids follow those of the scene.
// Complexity: O(1) each.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "geometry/projection/projected_scene.h"
#include "sweep/plain/active_edge_list.h"
#include "sweep/plain/depth_order.h"
#include "sweep/plain/event_queue.h"
#include "sweep/segments/image_decisions.h"

namespace sightline::inline sweep {

// Nothing changes places.
class NoSwaps {
 public:
  template <class Decider>
  NoSwaps(const Decider& /*decider*/, const ProjectedScene& /*scene*/, DepthOrder& /*depth*/,
          ActiveEdgeList& /*active*/) {}
  void begin(const SweepPoint& /*point*/) {}
  void look_right_of(EdgeId /*edge*/) {}
  void insert(BundleId /*left_neighbour*/, const NodeList& /*left*/, std::vector<BundleId>& /*below*/) {}
  template <class Queue>
  void queue(BundleId /*left_neighbour*/, BundleId /*right_neighbour*/, std::span<const BundleId> /*below*/,
             Queue& /*queue*/) {}
};

template <class Decisions>
class GridDecider {
 public:
  using Swaps = NoSwaps;
  static constexpr bool is_exact = Decisions::is_exact;
  using Place = typename Decisions::Place;
  using Height = double;  // the y of a place, rounded

  explicit GridDecider(const ProjectedScene& scene)
      : edges_(scene.edges), points_(scene.points), grid_bits_(scene.grid_bits) {
    direction_.reserve(scene.edge_count());
    for (std::size_t e = 0; e < scene.edge_count(); ++e)
      direction_.push_back(Decisions::direction(top(EdgeId(e)), bottom(EdgeId(e))));
  }

  // Returns +1 where, below a common point, a lies left of b; 0 where they lie on each other.
  [[nodiscard]] Sign turn(EdgeId a, EdgeId b) const {
    return Decisions::turn(direction_[a.index()], direction_[b.index()]);
  }
  // Returns +1 where p is right of the edge, 0 where it is on it.
  [[nodiscard]] Sign side(EdgeId e, PointId p) const { return Decisions::side(top(e), bottom(e), point(p)); }

  // Precondition: the edges cross.
  [[nodiscard]] Place place(EdgeId a, EdgeId b) const {
    return Decisions::crossing(top(a), bottom(a), top(b), bottom(b));
  }
  [[nodiscard]] Height height(EdgeId a, EdgeId b) const {
    return Decisions::crossing_height(top(a), bottom(a), top(b), bottom(b));
  }
  [[nodiscard]] Height height(PointId p) const { return Decisions::height(point(p)); }

  // These compare in sweep order: -1 where the first comes first, 0 where they are one point. Heights alone say 0, too, where
  // they do not decide.
  [[nodiscard]] static int compare_heights(Height a, Height b) { return Decisions::compare_heights(a, b); }
  [[nodiscard]] int compare(const Place& a, PointId p) const { return Decisions::compare(a, point(p)); }
  [[nodiscard]] static int compare(const Place& a, const Place& b) { return Decisions::compare(a, b); }

  [[nodiscard]] static bool is_number(const Place& p) {
    if constexpr (is_exact) return true;
    return Decisions::is_number(p);
  }

  // Returns the place in the window's units, rounded.
  [[nodiscard]] std::array<double, 2> in_window(PointId p) const { return in_window_units(point(p)); }
  [[nodiscard]] std::array<double, 2> in_window(const Place& p) const { return in_window_units(p); }

  [[nodiscard]] static bool is_swap_edge(EdgeId /*e*/) { return false; }
  [[nodiscard]] static std::array<FacetId, 2> surfaces_of_swap_edge(EdgeId /*e*/) { return {}; }

 private:
  [[nodiscard]] const ImagePoint& point(PointId p) const { return points_[p.index()]; }
  [[nodiscard]] const ImagePoint& top(EdgeId e) const { return point(edges_[e.index()].top); }
  [[nodiscard]] const ImagePoint& bottom(EdgeId e) const { return point(edges_[e.index()].bottom); }
  template <class Point>
  [[nodiscard]] std::array<double, 2> in_window_units(const Point& p) const {
    const double scale = std::ldexp(1.0, -grid_bits_);
    return {static_cast<double>(p.x) * scale, static_cast<double>(p.y) * scale};
  }

  std::span<const SceneEdge> edges_;
  std::span<const ImagePoint> points_;
  int grid_bits_ = default_grid_bits;
  std::vector<typename Decisions::Direction> direction_;
};

}  // namespace sightline::inline sweep
