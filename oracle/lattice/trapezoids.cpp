#include "oracle/lattice/trapezoids.h"

#include <algorithm>

namespace sightline::lattice {
namespace {

std::vector<Rise> rises_of(const std::vector<Ring>& rings) {
  std::vector<Rise> rises;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      const GridPoint p = rings[r][i];
      const GridPoint q = rings[r][(i + 1) % rings[r].size()];
      if (p.y < q.y) rises.push_back({p, q, r});
      if (p.y > q.y) rises.push_back({q, p, r});
    }
  }
  return rises;
}

std::vector<Fraction> heights(const std::vector<Rise>& rises) {
  std::vector<Fraction> result;
  for (std::size_t i = 0; i < rises.size(); ++i) {
    result.push_back({rises[i].bottom.y, 1});
    result.push_back({rises[i].top.y, 1});
    for (std::size_t j = 0; j < i; ++j) {
      if (const auto y = crossing_height(rises[i], rises[j])) result.push_back(*y);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Fraction between(const Fraction& a, const Fraction& b) {
  return {a.numerator * b.denominator + b.numerator * a.denominator, 2 * a.denominator * b.denominator};
}

// x is that of a rise times the height's denominator, over the rise's height; `order` compares it for two rises at
// one y.
struct Standing {
  Int128 x;
  Int128 rise_height;
  std::size_t rise;
};

Int128 order(const Standing& a, const Standing& b) { return a.x * b.rise_height - b.x * a.rise_height; }

std::vector<Standing> standing_at(const std::vector<Rise>& rises, const Fraction& y) {
  std::vector<Standing> result;
  for (std::size_t i = 0; i < rises.size(); ++i) {
    const Rise& r = rises[i];
    if (r.bottom.y * y.denominator > y.numerator || r.top.y * y.denominator < y.numerator) continue;
    result.push_back({place_on(r, y).x, r.top.y - r.bottom.y, i});
  }
  std::sort(result.begin(), result.end(), [](const Standing& a, const Standing& b) {
    const Int128 difference = order(a, b);
    return difference != 0 ? difference < 0 : a.rise < b.rise;
  });
  return result;
}

void toggle(std::vector<std::size_t>& inside, std::size_t ring) {
  const auto place = std::lower_bound(inside.begin(), inside.end(), ring);
  if (place != inside.end() && *place == ring) {
    inside.erase(place);
  } else {
    inside.insert(place, ring);
  }
}

std::vector<Trapezoid> trapezoids_at(const std::vector<Rise>& rises, const Fraction& y) {
  std::vector<Trapezoid> result;
  std::vector<std::size_t> inside;
  const std::vector<Standing> standing = standing_at(rises, y);
  for (std::size_t first = 0; first < standing.size();) {
    std::size_t last = first;
    for (; last < standing.size() && order(standing[first], standing[last]) == 0; ++last) {
      toggle(inside, rises[standing[last].rise].ring);
    }
    if (last < standing.size()) result.push_back({standing[first].rise, standing[last].rise, inside});
    first = last;
  }
  return result;
}

}  // namespace

bool operator<(const Fraction& a, const Fraction& b) {
  return a.numerator * b.denominator < b.numerator * a.denominator;
}
bool operator==(const Fraction& a, const Fraction& b) {
  return a.numerator * b.denominator == b.numerator * a.denominator;
}

Place place_on(const Rise& rise, const Fraction& y) {
  const Int128 height = rise.top.y - rise.bottom.y;
  const Int128 above = y.numerator - rise.bottom.y * y.denominator;
  return {rise.bottom.x * height * y.denominator + above * (rise.top.x - rise.bottom.x), y.numerator * height,
          height * y.denominator};
}

Place middle(const Place& a, const Place& b) {
  return {a.x * b.denominator + b.x * a.denominator, a.y * b.denominator + b.y * a.denominator,
          2 * a.denominator * b.denominator};
}

std::optional<Fraction> crossing_height(const Rise& a, const Rise& b) {
  const Int128 ax = a.top.x - a.bottom.x;
  const Int128 ay = a.top.y - a.bottom.y;
  const Int128 bx = b.top.x - b.bottom.x;
  const Int128 by = b.top.y - b.bottom.y;
  Int128 cross = ax * by - ay * bx;
  if (cross == 0) return std::nullopt;
  const Int128 ox = b.bottom.x - a.bottom.x;
  const Int128 oy = b.bottom.y - a.bottom.y;
  Int128 along = ox * by - oy * bx;
  if (cross < 0) {
    cross = -cross;
    along = -along;
  }
  const Fraction y{a.bottom.y * cross + along * ay, cross};
  const auto reaches = [&](const Rise& r) { return !(y < Fraction{r.bottom.y, 1}) && !(Fraction{r.top.y, 1} < y); };
  if (!reaches(a) || !reaches(b)) return std::nullopt;
  return y;
}

Decomposition decompose(const std::vector<Ring>& rings) {
  Decomposition result{rises_of(rings), {}};
  const std::vector<Fraction> ys = heights(result.rises);
  for (std::size_t i = 0; i + 1 < ys.size(); ++i) {
    result.slabs.push_back({ys[i], ys[i + 1], trapezoids_at(result.rises, between(ys[i], ys[i + 1]))});
  }
  return result;
}

}  // namespace sightline::lattice
