#include "peers/lines/cohen_sutherland.h"

#include <utility>

namespace sightline::peers {
namespace {

Point2 at_height(const Point2& c, const Point2& d, double y) {
  return {c.x + (d.x - c.x) * (y - c.y) / (d.y - c.y), y};
}

Point2 at_place_across(const Point2& c, const Point2& d, double x) {
  return {x, c.y + (d.y - c.y) * (x - c.x) / (d.x - c.x)};
}

// Returns the end c, which is outside, moved along the line to the first of the window's lines that it is beyond.
Point2 cut(const Point2& c, const Point2& d, Outcode code, const Window& window) {
  if ((code & above_bit) != 0) return at_height(c, d, window.y_max);
  if ((code & below_bit) != 0) return at_height(c, d, window.y_min);
  if ((code & right_bit) != 0) return at_place_across(c, d, window.x_max);
  return at_place_across(c, d, window.x_min);
}

}  // namespace

Outcode outcode_of(const Point2& v, const Window& window) {
  Outcode code = 0;
  if (v.y > window.y_max) code |= above_bit;
  if (v.y < window.y_min) code |= below_bit;
  if (v.x > window.x_max) code |= right_bit;
  if (v.x < window.x_min) code |= left_bit;
  return code;
}

std::optional<Line> cohen_sutherland(const Line& line, const Window& window) {
  Point2 v1 = line.from;
  Point2 v2 = line.to;
  while (true) {
    const Outcode c1 = outcode_of(v1, window);
    const Outcode c2 = outcode_of(v2, window);
    if (c1 == 0 && c2 == 0) return Line{v1, v2};
    if ((c1 & c2) != 0) return std::nullopt;
    if (c1 != 0) {
      v1 = cut(v1, v2, c1, window);
    } else {
      v2 = cut(v2, v1, c2, window);
    }
  }
}

}  // namespace sightline::peers
