#include "sweep/fast/cell_grid.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace sightline::inline sweep {
namespace {

// A coordinate of a point on an edge is off by at most this, with its rounding outwards: the quotient, the product and
// the sum round a number below 2^42 by 2^-10 together.
constexpr double margin = 1;

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

// Adds the x of that part of the edge that lies between two heights.
void add_between(const ImagePoint& a, const ImagePoint& b, double bottom, double top, Extent& extent) {
  const auto low = static_cast<double>(std::min(a.y, b.y));
  const auto high = static_cast<double>(std::max(a.y, b.y));
  if (high < bottom || low > top) return;
  if (low == high) {
    extent.add(static_cast<double>(a.x));
    extent.add(static_cast<double>(b.x));
    return;
  }
  const double slope = static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y);
  for (const double y : {std::max(low, bottom), std::min(high, top)}) {
    extent.add(static_cast<double>(a.x) + (y - static_cast<double>(a.y)) * slope);
  }
}

}  // namespace

int highest_level_for(std::size_t facets) {
  constexpr std::size_t most_cells_per_facet = 64;
  return static_cast<int>(std::bit_width(1 + most_cells_per_facet * facets) - 1) / 2;
}

CellGrid::CellGrid(int grid_bits, int level, int spread)
    : level_(std::clamp(level, 0, grid_bits)),
      spread_(spread),
      shift_(grid_bits + 1 - level_),
      half_window_(std::int64_t{1} << grid_bits) {}

ImagePoint CellGrid::centre(unsigned column, unsigned row) const {
  const auto middle = [this](unsigned i) { return (std::int64_t{i} << shift_) + cell_size() / 2 - half_window_; };
  return {middle(column), middle(row)};
}

unsigned CellGrid::first_touched(std::int64_t coordinate) const {
  const std::int64_t from_edge = std::max<std::int64_t>(coordinate + half_window_ - 1, 0);
  return static_cast<unsigned>(std::min<std::int64_t>(from_edge >> shift_, (std::int64_t{1} << level_) - 1));
}

unsigned CellGrid::last_touched(std::int64_t coordinate) const {
  const std::int64_t from_edge = std::max<std::int64_t>(coordinate + half_window_, 0);
  return static_cast<unsigned>(std::min<std::int64_t>(from_edge >> shift_, (std::int64_t{1} << level_) - 1));
}

CellRange CellGrid::range_of(std::span<const ImagePoint> points) const {
  ImagePoint low = points.front();
  ImagePoint high = points.front();
  for (const ImagePoint& p : points.subspan(1)) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto small = [](unsigned i) { return static_cast<std::uint16_t>(i); };
  return {small(first_touched(low.x - spread_)), small(first_touched(low.y - spread_)),
          small(last_touched(high.x + spread_)), small(last_touched(high.y + spread_))};
}

CellGrid::Rows CellGrid::columns_by_row(std::span<const ImagePoint> polygon, const CellRange& range) const {
  Rows rows;
  for (unsigned row = range.bottom; row <= range.top; ++row) {
    const ImagePoint middle = centre(0, row);
    const double around = margin + spread_;
    const double half = static_cast<double>(cell_size()) / 2 + around;
    const double bottom = static_cast<double>(middle.y) - half;
    const double top = static_cast<double>(middle.y) + half;
    Extent extent;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      add_between(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1], bottom, top, extent);
    }
    if (extent.low > extent.high) {
      rows.emplace_back();
      continue;
    }
    rows.push_back({std::max<unsigned>(first_touched(static_cast<std::int64_t>(extent.low - around)), range.left),
                    std::min<unsigned>(last_touched(static_cast<std::int64_t>(extent.high + around)), range.right)});
  }
  return rows;
}

}  // namespace sightline::inline sweep
