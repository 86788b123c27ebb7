// Every decision that the sweep takes in the image, in one arithmetic: a policy that the sweep is compiled with.
//
// In:  image points in grid units, edges top to bottom.
// Out: on which side of an edge a point lies, which of two edges is left of the other below a common point, where two
//      edges cross, and the sweep order of crossings.
//   - ExactDecisions: in integers, never rounded.
//   - UnfilteredDecisions<Real>: plain evaluation in float or double. The order of directions is still an order (it
//     compares slopes, one number per edge), and so is the order of places; the rest may be wrong.
// Complexity: O(1) each.
#pragma once

#include <cmath>
#include <limits>

#include "sweep/segments/crossing_point.h"

namespace sightline::inline sweep {

struct ExactDecisions {
  static constexpr bool is_exact = true;
  using Place = CrossingPoint;
  using Direction = ImagePoint;

  static Direction direction(const ImagePoint& top, const ImagePoint& bottom) {
    return {bottom.x - top.x, bottom.y - top.y};
  }
  // Returns +1 where, below a common point, u lies left of v; 0 where they lie on each other.
  static Sign turn(const Direction& u, const Direction& v) {
    return sign_of(static_cast<Int128>(u.x) * v.y - static_cast<Int128>(u.y) * v.x);
  }
  // Returns +1 where p is right of the edge, 0 where it is on it.
  static Sign side(const ImagePoint& top, const ImagePoint& bottom, const ImagePoint& p) {
    return orientation(top, bottom, p);
  }
  static Place crossing(const ImagePoint& top_a, const ImagePoint& bottom_a, const ImagePoint& top_b,
                        const ImagePoint& bottom_b) {
    return crossing_point(top_a, bottom_a, top_b, bottom_b);
  }
  // Returns the y of a place, rounded.
  static double crossing_height(const ImagePoint& top_a, const ImagePoint& bottom_a, const ImagePoint& top_b,
                                const ImagePoint& bottom_b) {
    return sightline::crossing_height(top_a, bottom_a, top_b, bottom_b);
  }
  static double height(const ImagePoint& p) { return static_cast<double>(p.y); }
  // Compares in sweep order: -1 where the first comes first, 0 where they are one point.
  static int compare(const Place& a, const ImagePoint& b) { return sweep_compare(a, b); }
  static int compare(const Place& a, const Place& b) { return sweep_compare(a, b); }
  // Compares by heights alone; 0 where these do not decide.
  static int compare_heights(double a, double b) {
    const double apart = b - a;
    return std::fabs(apart) > crossing_order_bound ? (apart > 0 ? 1 : -1) : 0;
  }
};

template <class Real>
struct UnfilteredDecisions {
  static constexpr bool is_exact = false;
  struct Place {
    Real x = 0;
    Real y = 0;
  };
  // A direction says how far right an edge goes for one unit down; it is infinite for a horizontal edge, which comes
  // last from left to right.
  using Direction = Real;

  static Direction direction(const ImagePoint& top, const ImagePoint& bottom) {
    const Place from = place(top);
    const Place to = place(bottom);
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    if (from.y == to.y) return to.x < from.x ? -infinity : infinity;
    return (to.x - from.x) / (from.y - to.y);
  }
  static Sign turn(Direction u, Direction v) { return v > u ? 1 : (v < u ? -1 : 0); }
  static Sign side(const ImagePoint& top, const ImagePoint& bottom, const ImagePoint& p) {
    const Place a = place(top);
    return sign_of(cross(minus(place(bottom), a), minus(place(p), a)));
  }
  static Place crossing(const ImagePoint& top_a, const ImagePoint& bottom_a, const ImagePoint& top_b,
                        const ImagePoint& bottom_b) {
    const Place a = place(top_a);
    const Place u = minus(place(bottom_a), a);
    const Place v = minus(place(bottom_b), place(top_b));
    const Real along_a = cross(minus(place(top_b), a), v) / cross(u, v);
    return {a.x + along_a * u.x, a.y + along_a * u.y};
  }
  static double crossing_height(const ImagePoint& top_a, const ImagePoint& bottom_a, const ImagePoint& top_b,
                                const ImagePoint& bottom_b) {
    return crossing(top_a, bottom_a, top_b, bottom_b).y;
  }
  static double height(const ImagePoint& p) { return place(p).y; }
  // Compares places that are numbers.
  static int compare(const Place& a, const Place& b) {
    if (a.y != b.y) return a.y > b.y ? -1 : 1;
    return a.x < b.x ? -1 : (a.x > b.x ? 1 : 0);
  }
  static int compare(const Place& a, const ImagePoint& b) { return compare(a, place(b)); }
  static int compare_heights(double a, double b) { return a > b ? -1 : (a < b ? 1 : 0); }
  static bool is_number(const Place& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

 private:
  static Place place(const ImagePoint& p) { return {static_cast<Real>(p.x), static_cast<Real>(p.y)}; }
  static Place minus(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y}; }
  static Real cross(const Place& a, const Place& b) { return a.x * b.y - a.y * b.x; }
};

}  // namespace sightline::inline sweep
