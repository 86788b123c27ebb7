#include "reflect/regions/polygon_outline.h"

#include <algorithm>
#include <cmath>

namespace sightline::inline reflect {
namespace {

// This is more than approximate places are off by, and more than their products lose.
constexpr double margin = 2;

}  // namespace

double PolygonOutline::Side::left_of(const Point2& p) const {
  const double cross = (end.x - start.x) * (p.y - start.y) - (end.y - start.y) * (p.x - start.x);
  return cross / std::hypot(end.x - start.x, end.y - start.y);
}

PolygonOutline::PolygonOutline(const RegionBorder& border) {
  for (const BorderSegment& segment : border)
    sides_.push_back({{segment.start.at.x, segment.start.at.y}, {segment.end.at.x, segment.end.at.y}});
}

SquarePlace PolygonOutline::place_of(const ImagePoint& low, std::int64_t size) const {
  const double half = static_cast<double>(size) / 2;
  const Point2 middle{static_cast<double>(low.x) + half, static_cast<double>(low.y) + half};
  const double reach = half + margin;
  for (const Side& side : sides_) {
    const auto& [start, end] = side;
    const bool apart = std::max(start.x, end.x) < middle.x - reach || std::min(start.x, end.x) > middle.x + reach ||
                       std::max(start.y, end.y) < middle.y - reach || std::min(start.y, end.y) > middle.y + reach;
    if (!apart && std::fabs(side.left_of(middle)) <= 2 * reach) return SquarePlace::across;
  }
  return winding(middle) == 0 ? SquarePlace::outside : SquarePlace::inside;
}

// Precondition: no side is near p.
int PolygonOutline::winding(const Point2& p) const {
  int winding = 0;
  for (const Side& side : sides_) {
    const auto& [start, end] = side;
    if ((start.y > p.y) == (end.y > p.y)) continue;
    const double left = side.left_of(p);
    if (end.y > start.y && left > 0) ++winding;
    if (end.y < start.y && left < 0) --winding;
  }
  return winding;
}

}  // namespace sightline::inline reflect
