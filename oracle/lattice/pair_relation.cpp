#include "oracle/lattice/pair_relation.h"

#include <algorithm>

#include "oracle/lattice/oracle.h"

namespace sightline::lattice {
namespace {

bool apart(const Ring& a, const Ring& b) {
  const auto by_x = [](const GridPoint& p, const GridPoint& q) { return p.x < q.x; };
  const auto by_y = [](const GridPoint& p, const GridPoint& q) { return p.y < q.y; };
  const auto [ax0, ax1] = std::minmax_element(a.begin(), a.end(), by_x);
  const auto [bx0, bx1] = std::minmax_element(b.begin(), b.end(), by_x);
  const auto [ay0, ay1] = std::minmax_element(a.begin(), a.end(), by_y);
  const auto [by0, by1] = std::minmax_element(b.begin(), b.end(), by_y);
  return ax1->x <= bx0->x || bx1->x <= ax0->x || ay1->y <= by0->y || by1->y <= ay0->y;
}

bool one_side(const PlacedFace& a, const Plane& plane) {
  int signs = 0;
  for (const CameraPoint& p : a.corners) signs |= 1 << (side(plane, p).sign() + 1);
  return (signs & 1) == 0 || (signs & 4) == 0;
}

// Returns the signs of `a nearer than b` in the corners of their overlap: bit 0 says farther, bit 1 equal, bit 2
// nearer.
int orders_in_overlap(const PlacedFace& a, const PlacedFace& b) {
  const Decomposition decomposition = decompose({a.image, b.image});
  int orders = 0;
  for (const Slab& slab : decomposition.slabs) {
    for (const Trapezoid& t : slab.trapezoids) {
      if (t.inside.size() < 2) continue;
      for (const Fraction& y : {slab.bottom, slab.top}) {
        for (const std::size_t rise : {t.left, t.right}) {
          orders |= 1 << (nearer(a.plane, b.plane, place_on(decomposition.rises[rise], y)) + 1);
        }
      }
    }
  }
  return orders;
}

}  // namespace

bool straddle(const PlacedFace& a, const PlacedFace& b) { return !one_side(a, b.plane) && !one_side(b, a.plane); }

Relation relation(const PlacedFace& a, const PlacedFace& b) {
  if (a.plane.c == 0 || b.plane.c == 0 || a.image.size() < 3 || b.image.size() < 3 || apart(a.image, b.image)) {
    return Relation::separate;
  }
  const int orders = orders_in_overlap(a, b);
  if (orders == 0) return Relation::separate;
  if (orders == 2) return Relation::coplanar;
  return (orders & 1) != 0 && (orders & 4) != 0 ? Relation::crossing : Relation::ordered;
}

}  // namespace sightline::lattice
