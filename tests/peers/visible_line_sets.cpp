#include "tests/peers/visible_line_sets.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sweep/segments/image_points.h"

namespace sightline::tests {

using peers::VisibleLine;
using peers::VisibleLines;

namespace {

constexpr double tolerance = 1e-9;

struct Interval {
  double begin = 0;
  double end = 0;
};

// Returns what of `other` lies on the line, as an interval of its length.
std::optional<Interval> common_part(const VisibleLine& line, double length, const VisibleLine& other) {
  const Point2 along{(line.to.x - line.from.x) / length, (line.to.y - line.from.y) / length};
  const auto place = [&](const Point2& p) {
    const Point2 from_start{p.x - line.from.x, p.y - line.from.y};
    return Point2{along.x * from_start.x + along.y * from_start.y, along.x * from_start.y - along.y * from_start.x};
  };
  Point2 a = place(other.from);
  Point2 b = place(other.to);
  if (a.x > b.x) std::swap(a, b);
  const Interval part{std::max(a.x, 0.0), std::min(b.x, length)};
  if (!(part.begin < part.end)) return std::nullopt;
  const auto aside = [&](double x) { return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x); };
  if (std::abs(aside(part.begin)) > tolerance || std::abs(aside(part.end)) > tolerance) return std::nullopt;
  return part;
}

// Returns how much of the line none of the others covers: gaps of up to twice the tolerance do not count.
double uncovered(const VisibleLine& line, const VisibleLines& others) {
  const double length = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
  if (length <= tolerance) return 0;
  std::vector<Interval> parts;
  for (const VisibleLine& other : others) {
    if (const auto part = common_part(line, length, other)) parts.push_back(*part);
  }
  std::sort(parts.begin(), parts.end(), [](const Interval& a, const Interval& b) { return a.begin < b.begin; });
  double total = 0;
  double reached = 0;
  const auto reach = [&](double next) { total += next - reached > 2 * tolerance ? next - reached : 0; };
  for (const Interval& part : parts) {
    reach(part.begin);
    reached = std::max(reached, part.end);
  }
  reach(length);
  return total;
}

}  // namespace

VisibleLines visible_segments(const View& view) {
  const ImagePoints points(view.scene, view.segments);
  VisibleLines lines;
  for (const VisibleSegment& segment : view.segments.segments) {
    const Point2 start = points.in_window(segment.start);
    const Point2 end = points.in_window(segment.end);
    const bool upright = start.x == end.x && std::abs(start.x) == 1;
    const bool level = start.y == end.y && std::abs(start.y) == 1;
    if (!upright && !level) lines.push_back({start, end});
  }
  return lines;
}

double uncovered(const VisibleLines& lines, const VisibleLines& others) {
  double total = 0;
  for (const VisibleLine& line : lines) total += uncovered(line, others);
  return total;
}

}  // namespace sightline::tests
