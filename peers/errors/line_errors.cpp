#include "peers/errors/line_errors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "peers/scene/ring_grid.h"

namespace sightline::peers {
namespace {

double length_of(const VisibleLine& line) { return std::hypot(line.to.x - line.from.x, line.to.y - line.from.y); }

double length_of(const VisibleLines& lines) {
  double length = 0;
  for (const VisibleLine& line : lines) length += length_of(line);
  return length;
}

// A place says where a point lies by a line: along it from its start, and beside it.
struct Place {
  double along = 0;
  double beside = 0;
};

Place place_of(const Point2& p, const VisibleLine& line, double length) {
  const Point2 direction{(line.to.x - line.from.x) / length, (line.to.y - line.from.y) / length};
  const Point2 to{p.x - line.from.x, p.y - line.from.y};
  return {to.x * direction.x + to.y * direction.y, to.y * direction.x - to.x * direction.y};
}

using Interval = std::array<double, 2>;

// Returns the interval of `other` on the line; it is empty where they lie on different lines.
Interval common_interval(const VisibleLine& line, const VisibleLine& other, double length) {
  const Place from = place_of(other.from, line, length);
  const Place to = place_of(other.to, line, length);
  if (std::max(std::abs(from.beside), std::abs(to.beside)) > same_line) return {0, 0};
  return {std::max(0.0, std::min(from.along, to.along)), std::min(length, std::max(from.along, to.along))};
}

double union_length(std::vector<Interval>& intervals) {
  std::sort(intervals.begin(), intervals.end());
  double covered = 0;
  double end = 0;
  for (const Interval& interval : intervals) {
    covered += std::max(0.0, interval[1] - std::max(end, interval[0]));
    end = std::max(end, interval[1]);
  }
  return covered;
}

VisibleParts as_parts(const VisibleLines& lines) {
  VisibleParts parts;
  for (const VisibleLine& line : lines) parts.push_back({FaceId{}, {line.from, line.to}});
  return parts;
}

// Returns the length of those parts of the lines that the others cover.
double covered_length(const VisibleLines& lines, const VisibleLines& others) {
  RingGrid grid(as_parts(others));
  double covered = 0;
  for (const VisibleLine& line : lines) {
    const double length = length_of(line);
    if (length == 0) continue;
    std::vector<Interval> intervals;
    for (const std::size_t other : grid.near({line.from, line.to})) {
      const Interval common = common_interval(line, others[other], length);
      if (common[0] < common[1]) intervals.push_back(common);
    }
    covered += union_length(intervals);
  }
  return covered;
}

}  // namespace

LineErrors errors_of(const VisibleLines& seen, const VisibleLines& exact) {
  LineErrors errors;
  errors.length = length_of(seen);
  const double visible = length_of(exact);
  if (visible == 0) return errors;
  errors.missing_share = std::max(0.0, visible - covered_length(exact, seen)) / visible;
  errors.hidden_share = std::max(0.0, errors.length - covered_length(seen, exact)) / visible;
  return errors;
}

}  // namespace sightline::peers
