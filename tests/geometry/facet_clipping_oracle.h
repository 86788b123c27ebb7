// How two convex polygons meet, in rationals, by clipping one to the other. Shares only the names of the answers with
// the library.
//
// In:  strictly convex planar polygons; corners are shared where their positions are equal.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <set>
#include <string>
#include <vector>

#include "geometry/cutting/facet_contact.h"

namespace sightline::clipping_oracle {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;
using RationalPolygon = std::vector<RationalPoint>;

inline RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Rational inner(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline RationalPoint outer(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// These are the points x with normal . (x - origin) >= 0.
struct HalfSpace {
  RationalPoint normal;
  RationalPoint origin;
  [[nodiscard]] Rational operator()(const RationalPoint& x) const { return inner(normal, minus(x, origin)); }
};

inline RationalPoint point_at_zero(const HalfSpace& h, const RationalPoint& p, const RationalPoint& q) {
  const Rational t = h(p) / (h(p) - h(q));
  const RationalPoint d = minus(q, p);
  return {p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]};
}

inline RationalPolygon clip(const RationalPolygon& polygon, const HalfSpace& h) {
  RationalPolygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint& p = polygon[i];
    const RationalPoint& q = polygon[(i + 1) % polygon.size()];
    if (h(p) >= 0) result.push_back(p);
    if (h(p) * h(q) < 0) result.push_back(point_at_zero(h, p, q));
  }
  return result;
}

// Precondition: the polygon is strictly convex, so that its first three corners are not on one line.
inline HalfSpace above(const RationalPolygon& polygon) {
  return {outer(minus(polygon[1], polygon[0]), minus(polygon[2], polygon[0])), polygon[0]};
}

inline std::vector<HalfSpace> inner_sides(const RationalPolygon& polygon) {
  std::vector<HalfSpace> sides;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sides.push_back({outer(above(polygon).normal, minus(polygon[(i + 1) % polygon.size()], polygon[i])), polygon[i]});
  }
  return sides;
}

inline std::set<RationalPoint> meeting_points(const RationalPolygon& a, const RationalPolygon& b) {
  const HalfSpace up = above(b);
  const RationalPoint opposite = minus({0, 0, 0}, up.normal);
  RationalPolygon common = clip(clip(a, up), {opposite, up.origin});
  for (const HalfSpace& side : inner_sides(b)) common = clip(common, side);
  return {common.begin(), common.end()};
}

inline bool strictly_inside(const RationalPolygon& polygon, const RationalPoint& x) {
  const auto sides = inner_sides(polygon);
  return std::all_of(sides.begin(), sides.end(), [&](const HalfSpace& h) { return h(x) > 0; });
}

inline bool an_edge_crosses(const RationalPolygon& a, const RationalPolygon& b) {
  const HalfSpace up = above(b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const RationalPoint& p = a[i];
    const RationalPoint& q = a[(i + 1) % a.size()];
    if (up(p) * up(q) < 0 && strictly_inside(b, point_at_zero(up, p, q))) return true;
  }
  return false;
}

inline bool is_corner(const RationalPolygon& polygon, const RationalPoint& p) {
  return std::find(polygon.begin(), polygon.end(), p) != polygon.end();
}

inline bool is_edge(const RationalPolygon& polygon, const RationalPoint& p, const RationalPoint& q) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint& next = polygon[(i + 1) % polygon.size()];
    if ((polygon[i] == p && next == q) || (polygon[i] == q && next == p)) return true;
  }
  return false;
}

inline bool is_shared(const RationalPolygon& a, const RationalPolygon& b, const std::set<RationalPoint>& points) {
  if (std::any_of(points.begin(), points.end(), [&](const auto& p) { return !is_corner(a, p) || !is_corner(b, p); })) {
    return false;
  }
  if (points.size() < 2) return true;
  return points.size() == 2 && is_edge(a, *points.begin(), *points.rbegin()) &&
         is_edge(b, *points.begin(), *points.rbegin());
}

// Returns whether the middle of the line they meet in is inside both, and their planes differ.
inline bool interiors_cross(const RationalPolygon& a, const RationalPolygon& b) {
  const auto points = meeting_points(a, b);
  if (points.size() < 2 || outer(above(a).normal, above(b).normal) == RationalPoint{0, 0, 0}) return false;
  RationalPoint middle;
  for (std::size_t i = 0; i < 3; ++i) middle[i] = ((*points.begin())[i] + (*points.rbegin())[i]) / 2;
  return strictly_inside(a, middle) && strictly_inside(b, middle);
}

inline Contact contact_by_clipping(const RationalPolygon& a, const RationalPolygon& b) {
  if (interiors_cross(a, b)) return Contact::crossing;
  return is_shared(a, b, meeting_points(a, b)) ? Contact::none : Contact::touching;
}

// Returns what kind of case a pair is, so that the test can tell that it had them all.
inline std::string kind(const RationalPolygon& a, const RationalPolygon& b, Contact contact) {
  const auto shared = std::count_if(a.begin(), a.end(), [&](const RationalPoint& p) { return is_corner(b, p); });
  if (contact == Contact::none) return "apart, shared corners: " + std::to_string(shared);
  if (contact == Contact::crossing) {
    const bool by_edge = an_edge_crosses(a, b) || an_edge_crosses(b, a);
    return std::string("crossing, ") +
           (by_edge ? "shared corners: " + std::to_string(shared) : "along a chord of both");
  }
  if (std::all_of(b.begin(), b.end(), [&](const RationalPoint& p) { return above(a)(p) == 0; })) {
    return "touching in one plane, shared corners: " + std::to_string(shared);
  }
  for (const RationalPoint& p : meeting_points(a, b)) {
    if (!is_corner(a, p) && !is_corner(b, p)) return "touching, edge on edge";
    if (strictly_inside(a, p) || strictly_inside(b, p)) return "touching, corner in a facet";
    if (is_corner(a, p) != is_corner(b, p)) return "touching, corner on an edge";
  }
  return "touching, along an edge";
}

}  // namespace sightline::clipping_oracle
