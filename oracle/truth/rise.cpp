#include "oracle/truth/rise.h"

#include <algorithm>
#include <optional>

namespace sightline::oracle::image {
namespace {

std::optional<Rise> rise_of(const Side& side, const Point& end, std::size_t shape) {
  if (side.line.a == 0) return std::nullopt;
  // The inner side is on the left, so a side runs up where a is negative.
  const bool up = side.line.a < 0;
  const Point& bottom = up ? side.start : end;
  const Point& top = up ? end : side.start;
  const Key bottom_x = key_of(bottom.x, bottom.w);
  const Key top_x = key_of(top.x, top.w);
  Rise rise;
  rise.line = up ? opposite(side.line) : side.line;
  rise.bottom = fraction(bottom.y, bottom.w);
  rise.top = fraction(top.y, top.w);
  rise.left = std::min(bottom_x, top_x);
  rise.right = std::max(bottom_x, top_x);
  rise.shape = shape;
  rise.winding = up ? -1 : 1;
  return rise;
}

void add_rises(std::vector<Rise>& rises, const Shape& shape, std::size_t number) {
  for (const Outline& outline : shape) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      auto rise = rise_of(outline[i], outline[(i + 1) % outline.size()].start, number);
      if (rise) rises.push_back(std::move(*rise));
    }
  }
}

struct Box {
  Fraction bottom;
  Fraction top;
  Key left = 0;
  Key right = 0;
};

// Returns the box of the rises of shape 0; there is one.
Box box_of(const std::vector<Rise>& rises) {
  Box box{rises[0].bottom, rises[0].top, rises[0].left, rises[0].right};
  for (const Rise& rise : rises) {
    if (rise.shape != 0) continue;
    if (rise.bottom < box.bottom) box.bottom = rise.bottom;
    if (box.top < rise.top) box.top = rise.top;
    box.left = std::min(box.left, rise.left);
    box.right = std::max(box.right, rise.right);
  }
  return box;
}

bool can_cross(const Rise& a, const Rise& b, const Box& box) {
  if (a.line == b.line) return false;
  const Key left = std::max({a.left, b.left, box.left});
  const Key right = std::min({a.right, b.right, box.right});
  const Key bottom = std::max({a.bottom.key, b.bottom.key, box.bottom.key});
  const Key top = std::min({a.top.key, b.top.key, box.top.key});
  return left <= right && bottom <= top;
}

// A height too many does no harm, so the ends' keys decide whether the lines' meeting point is on both.
std::optional<Fraction> crossing_height(const Rise& a, const Rise& b) {
  const Integer turn = a.line.a * b.line.b - a.line.b * b.line.a;
  if (turn == 0) return std::nullopt;
  Fraction y = fraction(a.line.c * b.line.a - a.line.a * b.line.c, turn);
  if (y.key < std::max(a.bottom.key, b.bottom.key) || y.key > std::min(a.top.key, b.top.key)) return std::nullopt;
  return y;
}

}  // namespace

std::vector<Rise> rises_of(const std::vector<Shape>& shapes) {
  std::vector<Rise> rises;
  for (std::size_t s = 0; s < shapes.size(); ++s) add_rises(rises, shapes[s], s);
  if (rises.empty() || rises[0].shape != 0) return {};
  const Box box = box_of(rises);
  std::erase_if(rises, [&](const Rise& rise) {
    return rise.left > box.right || !(rise.bottom < box.top) || !(box.bottom < rise.top);
  });
  return rises;
}

std::vector<Fraction> heights_of(const std::vector<Rise>& rises) {
  if (rises.empty()) return {};
  const Box box = box_of(rises);
  std::vector<Fraction> heights;
  for (std::size_t i = 0; i < rises.size(); ++i) {
    heights.push_back(rises[i].bottom);
    heights.push_back(rises[i].top);
    for (std::size_t j = 0; j < i; ++j) {
      if (!can_cross(rises[i], rises[j], box)) continue;
      if (auto y = crossing_height(rises[i], rises[j])) heights.push_back(std::move(*y));
    }
  }
  std::erase_if(heights, [&](const Fraction& y) { return y < box.bottom || box.top < y; });
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

}  // namespace sightline::oracle::image
