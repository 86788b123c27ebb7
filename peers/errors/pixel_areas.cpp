#include "peers/errors/pixel_areas.h"

#include <algorithm>
#include <cmath>

namespace sightline::peers {
namespace {

// Returns the point of the line from a to b at x, or at y; it is exactly at x or y.
Point2 at_x(const Point2& a, const Point2& b, double x) { return {x, a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x))}; }
Point2 at_y(const Point2& a, const Point2& b, double y) { return {a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)), y}; }

// Calls what(unit, from, to) for the segments of a side in each unit interval of a coordinate, in its direction.
template <class Coordinate, class At, class What>
void for_each_unit(const Point2& from, const Point2& to, int units, Coordinate coordinate, At at, What what) {
  const bool forward = coordinate(from) <= coordinate(to);
  const Point2& low = forward ? from : to;
  const Point2& high = forward ? to : from;
  const auto unit_of = [units](double value) { return std::clamp(static_cast<int>(std::floor(value)), 0, units - 1); };
  Point2 begin = low;
  for (int unit = unit_of(coordinate(low)); unit <= unit_of(coordinate(high)); ++unit) {
    const Point2 end = unit + 1 < coordinate(high) ? at(low, high, unit + 1.0) : high;
    forward ? what(unit, begin, end) : what(unit, end, begin);
    begin = end;
  }
}

}  // namespace

PixelAreas::PixelAreas(int resolution, std::span<const VisiblePart> parts) : resolution_(resolution) {
  Point2 least{static_cast<double>(resolution), static_cast<double>(resolution)};
  Point2 most{0, 0};
  for (const VisiblePart& part : parts) {
    for (const Point2& corner : part.ring) {
      const Point2 p = in_pixels(corner);
      least = {std::min(least.x, p.x), std::min(least.y, p.y)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
  }
  const auto first = [resolution](double value) { return std::clamp(static_cast<int>(value), 0, resolution - 1); };
  first_column_ = first(least.x);
  first_row_ = first(least.y);
  columns_ = first(most.x) - first_column_ + 1;
  rows_ = first(most.y) - first_row_ + 1;
  if (columns_ < 1 || rows_ < 1) columns_ = rows_ = 0;
  pixels_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (const VisiblePart& part : parts) {
    for (std::size_t i = 0; i < part.ring.size(); ++i) add_side(part.ring[i], part.ring[(i + 1) % part.ring.size()]);
  }
}

// Columns count from the left, rows from the top, in units of a pixel.
Point2 PixelAreas::in_pixels(const Point2& p) const {
  return {(p.x + 1) * (resolution_ / 2.0), (1 - p.y) * (resolution_ / 2.0)};
}

// y now grows downwards, so a counter-clockwise ring runs down on its left: there downwards adds.
void PixelAreas::add_side(const Point2& from, const Point2& to) {
  const Point2 origin{static_cast<double>(first_column_), static_cast<double>(first_row_)};
  const Point2 a{in_pixels(from).x - origin.x, in_pixels(from).y - origin.y};
  const Point2 b{in_pixels(to).x - origin.x, in_pixels(to).y - origin.y};
  if (a.y == b.y) return;
  for_each_unit(
      a, b, rows_, [](const Point2& p) { return p.y; }, at_y,
      [this](int row, const Point2& p, const Point2& q) { add_in_row(row, p, q); });
}

void PixelAreas::add_in_row(int row, const Point2& from, const Point2& to) {
  if (from.x == to.x) return add_in_pixel(std::clamp(static_cast<int>(from.x), 0, columns_ - 1), row, from, to);
  for_each_unit(
      from, to, columns_, [](const Point2& p) { return p.x; }, at_x,
      [this, row](int column, const Point2& p, const Point2& q) { add_in_pixel(column, row, p, q); });
}

void PixelAreas::add_in_pixel(int column, int row, const Point2& from, const Point2& to) {
  const double height = to.y - from.y;
  Pixel& pixel = pixels_[index(column, row)];
  pixel.trapezoids += height * (column + 1 - (from.x + to.x) / 2);
  pixel.height += height;
}

}  // namespace sightline::peers
