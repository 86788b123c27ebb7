#include "oracle/lattice/simple_polygon.h"

#include <algorithm>

namespace sightline::lattice {
namespace {

int turn_of(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return sign_of((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

bool on_segment(const GridPoint& a, const GridPoint& b, const GridPoint& p) {
  return turn_of(a, b, p) == 0 && std::min(a, b) <= p && p <= std::max(a, b);
}

bool meet(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  if (turn_of(a, b, c) * turn_of(a, b, d) < 0 && turn_of(c, d, a) * turn_of(c, d, b) < 0) return true;
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
}

bool all_collinear(const Ring& ring) {
  for (std::size_t j = 1; j < ring.size(); ++j) {
    for (std::size_t k = j + 1; k < ring.size(); ++k) {
      if (turn_of(ring[0], ring[j], ring[k]) != 0) return false;
    }
  }
  return true;
}

}  // namespace

Ring flattened(const std::vector<LatticePoint>& corners) {
  for (int axis = 0; axis < 3; ++axis) {
    Ring ring;
    for (const LatticePoint& p : corners) {
      if (axis == 0) ring.push_back({p.x, p.y});
      if (axis == 1) ring.push_back({p.y, p.depth});
      if (axis == 2) ring.push_back({p.depth, p.x});
    }
    if (!all_collinear(ring)) return ring;
  }
  return {};
}

bool is_simple(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const GridPoint& a = ring[i];
    const GridPoint& b = ring[(i + 1) % n];
    const GridPoint& c = ring[(i + 2) % n];
    if (a == b || on_segment(a, b, c) || on_segment(b, c, a)) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n != i && meet(a, b, ring[j], ring[(j + 1) % n])) return false;
    }
  }
  return true;
}

bool is_convex(const Ring& ring) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const int t = turn_of(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]);
    turns |= t > 0 ? 1 : (t < 0 ? 2 : 0);
  }
  return turns != 3;
}

}  // namespace sightline::lattice
