#include <algorithm>

#include "oracle/lattice/oracle.h"

namespace sightline::lattice {
namespace {

bool operator==(const Place& a, const Place& b) {
  return a.x * b.denominator == b.x * a.denominator && a.y * b.denominator == b.y * a.denominator;
}

bool before(const Place& a, const Place& b) {
  const Int128 left = a.y * b.denominator;
  const Int128 right = b.y * a.denominator;
  return left != right ? left < right : a.x * b.denominator < b.x * a.denominator;
}

struct Edge {
  GridPoint a;
  GridPoint b;
  friend constexpr auto operator<=>(const Edge&, const Edge&) = default;
};

std::int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool strictly_inside(const GridPoint& p, const Edge& e) { return turn(e.a, e.b, p) == 0 && e.a < p && p < e.b; }

// Returns where two edges cross in the interior of both.
std::optional<Place> crossing(const Edge& e, const Edge& f) {
  const std::int64_t fa = turn(e.a, e.b, f.a);
  const std::int64_t fb = turn(e.a, e.b, f.b);
  const std::int64_t ea = turn(f.a, f.b, e.a);
  const std::int64_t eb = turn(f.a, f.b, e.b);
  if (fa == 0 || fb == 0 || ea == 0 || eb == 0 || (fa > 0) == (fb > 0) || (ea > 0) == (eb > 0)) return std::nullopt;
  const Int128 whole = fa > fb ? fa - fb : fb - fa;
  const Int128 part = fa > 0 ? fa : -fa;
  return Place{f.a.x * whole + part * (f.b.x - f.a.x), f.a.y * whole + part * (f.b.y - f.a.y), whole};
}

// Returns the places of all corners, once for each corner in space.
std::vector<GridPoint> corners_in_space(const std::vector<OracleFace>& faces) {
  struct Corner {
    GridPoint point;
    const Plane* plane;
  };
  std::vector<Corner> corners;
  for (const OracleFace& face : faces) {
    for (const GridPoint& p : face.ring) corners.push_back({p, &face.plane});
  }
  const auto depth_order = [](const Corner& a, const Corner& b) {
    return nearer(*a.plane, *b.plane, {a.point.x, a.point.y, 1});
  };
  std::sort(corners.begin(), corners.end(), [&](const Corner& a, const Corner& b) {
    return a.point != b.point ? a.point < b.point : depth_order(a, b) > 0;
  });
  const auto same = [&](const Corner& a, const Corner& b) { return a.point == b.point && depth_order(a, b) == 0; };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  std::vector<GridPoint> result;
  for (const Corner& corner : corners) result.push_back(corner.point);
  return result;
}

std::vector<Edge> edges_in_image(const std::vector<OracleFace>& faces) {
  std::vector<Edge> edges;
  for (const OracleFace& face : faces) {
    for (std::size_t i = 0; i < face.ring.size(); ++i) {
      const GridPoint next = face.ring[(i + 1) % face.ring.size()];
      edges.push_back({std::min(face.ring[i], next), std::max(face.ring[i], next)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<Place> events(const std::vector<OracleFace>& faces) {
  const std::vector<GridPoint> corners = corners_in_space(faces);
  const std::vector<Edge> edges = edges_in_image(faces);
  std::vector<Place> result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const GridPoint& p = corners[i];
    result.push_back({p.x, p.y, 1});
    if (i > 0 && corners[i - 1] == p) continue;
    for (const Edge& e : edges) {
      if (strictly_inside(p, e)) result.push_back({p.x, p.y, 1});
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (const auto p = crossing(edges[i], edges[j])) result.push_back(*p);
    }
  }
  return result;
}

}  // namespace

Degeneracy degeneracy(const std::vector<OracleFace>& faces) {
  std::vector<Place> all = events(faces);
  std::sort(all.begin(), all.end(), before);
  Degeneracy result;
  for (std::size_t first = 0; first < all.size();) {
    std::size_t last = first;
    while (last < all.size() && all[first] == all[last]) ++last;
    ++result.points;
    result.degenerate += last - first > 1 ? 1 : 0;
    first = last;
  }
  return result;
}

}  // namespace sightline::lattice
