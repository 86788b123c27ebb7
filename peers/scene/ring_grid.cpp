#include "peers/scene/ring_grid.h"

#include <algorithm>
#include <cmath>

namespace sightline::peers {

RingGrid::RingGrid(const VisibleParts& parts)
    : size_(std::clamp(static_cast<int>(std::sqrt(static_cast<double>(parts.size()))), 1, 512)),
      cells_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_)) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Range range = range_of(parts[i].ring);
    for (int row = range.first[1]; row <= range.last[1]; ++row) {
      for (int column = range.first[0]; column <= range.last[0]; ++column) cell(column, row).push_back(i);
    }
  }
}

std::vector<std::size_t> RingGrid::near(const std::vector<Point2>& ring) {
  std::vector<std::size_t> found;
  const Range range = range_of(ring);
  for (int row = range.first[1]; row <= range.last[1]; ++row) {
    for (int column = range.first[0]; column <= range.last[0]; ++column) {
      const std::vector<std::size_t>& here = cell(column, row);
      found.insert(found.end(), here.begin(), here.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

RingGrid::Range RingGrid::range_of(const std::vector<Point2>& ring) const {
  const auto cell_of = [this](double w) { return std::clamp(static_cast<int>((w + 1) / 2 * size_), 0, size_ - 1); };
  Range range{{size_ - 1, size_ - 1}, {0, 0}};
  for (const Point2& p : ring) {
    const std::array place{cell_of(p.x), cell_of(p.y)};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      range.first.at(axis) = std::min(range.first.at(axis), place.at(axis));
      range.last.at(axis) = std::max(range.last.at(axis), place.at(axis));
    }
  }
  return range;
}

}  // namespace sightline::peers
