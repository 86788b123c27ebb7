#include "peers/painters/koucky_structures.h"

#include <algorithm>

namespace sightline::peers::thesis {
namespace {

bool is_left_of(const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

Vertex vertex_at(const Point2& p, const DepthPlane& plane) { return {p, plane.at(p.x, p.y), true}; }

Point2 crossing(Point2 a, Point2 b, Point2 c, Point2 d) {
  if (is_left_of(b, a)) std::swap(a, b);
  if (is_left_of(d, c)) std::swap(c, d);
  const auto side_of_cd = [&](const Point2& p) { return (c.x - p.x) * (d.y - p.y) - (c.y - p.y) * (d.x - p.x); };
  const double part = side_of_cd(a) / (side_of_cd(a) - side_of_cd(b));
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

}  // namespace

Structures structures_of(const FlatScene& scene) {
  Structures structures;
  for (const FlatPolygon& polygon : scene.polygons) {
    const ConvexRing ring = convex_image(polygon);
    const std::size_t first = structures.V.size();
    for (const Point2& p : ring) structures.V.push_back(vertex_at(p, polygon.plane));
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const MinMax extent = minmax_of({ring[0], ring[i - 1], ring[i]});
      structures.T.push_back({&polygon, {first, first + i - 1, first + i}, extent});
    }
  }
  return structures;
}

void add_triangle(Structures& structures, const FlatPolygon& polygon, const std::array<Point2, 3>& corners,
                  bool visible) {
  const std::size_t first = structures.V.size();
  for (const Point2& p : corners) structures.V.push_back(vertex_at(p, polygon.plane));
  const MinMax extent = minmax_of({corners[0], corners[1], corners[2]});
  structures.T.push_back({&polygon, {first, first + 1, first + 2}, extent, visible});
}

bool is_inside(const Point2& p, const ConvexRing& triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (p == triangle[i] || orient2d(triangle[i], triangle[(i + 1) % 3], p) < 0) return false;
  }
  return true;
}

Intersection intersection(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Sign at_a = orient2d(c, d, a);
  const Sign at_b = orient2d(c, d, b);
  const Sign at_c = orient2d(a, b, c);
  const Sign at_d = orient2d(a, b, d);
  if (at_a * at_b > 0 || at_c * at_d > 0 || at_a == at_b) return {};
  if (at_a == 0) return {true, a};
  if (at_b == 0) return {true, b};
  if (at_c == 0) return {true, c};
  if (at_d == 0) return {true, d};
  return {true, crossing(a, b, c, d)};
}

}  // namespace sightline::peers::thesis
