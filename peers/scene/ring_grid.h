// Which rings are near another one: a grid of cells over the window, each with the rings whose boxes touch it.
//
// Complexity: O(rings + cells that their boxes touch).
#pragma once

#include <array>
#include <vector>

#include "peers/scene/seen.h"

namespace sightline::peers {

class RingGrid {
 public:
  explicit RingGrid(const VisibleParts& parts);

  // Returns the indices of those parts whose boxes share a cell with the ring's box, ascending. It is not for two
  // threads at once.
  [[nodiscard]] std::vector<std::size_t> near(const std::vector<Point2>& ring);

 private:
  struct Range {
    std::array<int, 2> first;
    std::array<int, 2> last;
  };
  [[nodiscard]] Range range_of(const std::vector<Point2>& ring) const;
  [[nodiscard]] std::vector<std::size_t>& cell(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column)];
  }

  int size_;  // cells along each side
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace sightline::peers
