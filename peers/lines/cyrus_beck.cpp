#include "peers/lines/cyrus_beck.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace sightline::peers {
namespace {

Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
double dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }

Point2 at(const Line& line, double t) {
  if (t == 0) return line.from;
  if (t == 1) return line.to;
  return {line.from.x + t * (line.to.x - line.from.x), line.from.y + t * (line.to.y - line.from.y)};
}

// These are the slides' two sets of crossings.
struct Crossings {
  std::vector<double> PE{0};
  std::vector<double> PL{1};
  bool is_outside = false;  // of an edge that the line is parallel to

  // height = N . (P0 - P_E) is how far P0 is outside the edge, and rise = N . D.
  void add(double height, double rise) {
    if (rise < 0) {
      PE.push_back(height / -rise);
    } else if (rise > 0) {
      PL.push_back(height / -rise);
    } else if (height > 0) {
      is_outside = true;
    }
  }
};

std::optional<ClippedLine> between(const Line& line, const Crossings& crossings) {
  const double tE = *std::max_element(crossings.PE.begin(), crossings.PE.end());
  const double tL = *std::min_element(crossings.PL.begin(), crossings.PL.end());
  if (crossings.is_outside || tE > tL) return std::nullopt;
  return ClippedLine{tE, tL, {at(line, tE), at(line, tL)}};
}

// The normal points to the right of the edge: that is outwards, since the polygon is counter-clockwise.
Point2 outward_normal(const Point2& from, const Point2& to) {
  if (from == to) throw std::invalid_argument("cyrus_beck: an edge of the polygon has no length");
  return {to.y - from.y, from.x - to.x};
}

}  // namespace

std::optional<ClippedLine> cyrus_beck(const Line& line, std::span<const Point2> polygon) {
  const Point2 D = line.to - line.from;
  Crossings crossings;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& P_E = polygon[i];
    const Point2 N = outward_normal(P_E, polygon[(i + 1) % polygon.size()]);
    crossings.add(dot(N, line.from - P_E), dot(N, D));
  }
  return between(line, crossings);
}

std::optional<ClippedLine> cyrus_beck(const Line& line, const Window& window) {
  const Point2 D = line.to - line.from;
  Crossings crossings;
  crossings.add(-(line.from.x - window.x_min), -D.x);  // left: N = (-1, 0)
  crossings.add(line.from.x - window.x_max, D.x);      // right: N = (1, 0)
  crossings.add(-(line.from.y - window.y_min), -D.y);  // below: N = (0, -1)
  crossings.add(line.from.y - window.y_max, D.y);      // above: N = (0, 1)
  return between(line, crossings);
}

}  // namespace sightline::peers
