#include "peers/scene/convex_ring.h"

#include <algorithm>
#include <cmath>

namespace sightline::peers {
namespace {

// Returns twice the signed area of a, b, p, relative to p.
double side(const Point2& a, const Point2& b, const Point2& p) {
  return (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x);
}

const Point2& after(const ConvexRing& ring, std::size_t i) { return ring[i + 1 < ring.size() ? i + 1 : 0]; }

struct RingHalves {
  ConvexRing left;
  ConvexRing right;
};

void add(RingHalves& halves, const Point2& p, double side_of_p) {
  if (side_of_p >= 0) halves.left.push_back(p);
  if (side_of_p <= 0) halves.right.push_back(p);
}

// Returns both parts of a ring along the line through from and to.
RingHalves halves_of(const ConvexRing& ring, const Point2& from, const Point2& to) {
  RingHalves halves;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2& p = ring[i];
    const Point2& q = after(ring, i);
    const double at_p = side(from, to, p);
    const double at_q = side(from, to, q);
    add(halves, p, at_p);
    if ((at_p < 0) == (at_q < 0) || at_p == 0 || at_q == 0) continue;
    const double part = at_p / (at_p - at_q);
    add(halves, {p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)}, 0);
  }
  return halves;
}

// Adds one side of the hull: the corners, in order, between which all turns are to the left.
void add_chain(ConvexRing& hull, const std::vector<Point2>& points) {
  const std::size_t first = hull.size();
  for (const Point2& p : points) {
    while (hull.size() >= first + 2 && orient2d(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  }
  hull.pop_back();  // the other side begins with it
}

}  // namespace

MinMax minmax_of(const ConvexRing& ring) {
  MinMax extent{ring.front(), ring.front()};
  for (const Point2& p : ring) {
    extent.least = {std::min(extent.least.x, p.x), std::min(extent.least.y, p.y)};
    extent.most = {std::max(extent.most.x, p.x), std::max(extent.most.y, p.y)};
  }
  return extent;
}

bool extents_overlap(const MinMax& a, const MinMax& b) {
  return a.least.x <= b.most.x && b.least.x <= a.most.x && a.least.y <= b.most.y && b.least.y <= a.most.y;
}

bool contains(const MinMax& extent, const Point2& p) { return extents_overlap(extent, {p, p}); }

bool is_below_resolution(const ConvexRing& ring) {
  double perimeter = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2& q = after(ring, i);
    perimeter += std::hypot(q.x - ring[i].x, q.y - ring[i].y);
  }
  return 2 * signed_area(ring) <= std::ldexp(perimeter, -default_grid_bits);
}

// This has Andrew's monotone chains (1979), with exact turns.
ConvexRing convex_image(const FlatPolygon& polygon) {
  std::vector<Point2> points;
  for (const Corner& c : polygon.corners) points.push_back({c.x, c.y});
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  ConvexRing hull;
  if (points.size() < 3) return hull;
  add_chain(hull, points);
  std::reverse(points.begin(), points.end());
  add_chain(hull, points);
  return hull.size() < 3 ? ConvexRing{} : hull;
}

ConvexRing overlap(const ConvexRing& a, const ConvexRing& b) {
  ConvexRing common = a;
  for (std::size_t i = 0; i < b.size() && !common.empty(); ++i) common = halves_of(common, b[i], after(b, i)).left;
  return is_below_resolution(common) ? ConvexRing{} : common;
}

std::vector<ConvexRing> remains(const ConvexRing& ring, const ConvexRing& taken_away) {
  std::vector<ConvexRing> outside;
  ConvexRing common = ring;
  for (std::size_t i = 0; i < taken_away.size(); ++i) {
    RingHalves halves = halves_of(common, taken_away[i], after(taken_away, i));
    if (is_below_resolution(halves.left)) return {ring};
    if (!is_below_resolution(halves.right)) outside.push_back(std::move(halves.right));
    common = std::move(halves.left);
  }
  return outside;
}

}  // namespace sightline::peers
