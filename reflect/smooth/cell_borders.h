// The border of what is lit in the cells that a triangle of the image was divided into.
//
// In:  the cells that were not divided further (lit_cells.h), and the sides of cells that were halved.
// Out: directed segments between grid points, in closed rings: a place is lit where they wind around it more than zero times.
// Method: the border of a condition runs straight through a cell, between places of the cell's sides where the condition is zero: it is
//      taken as linear along the side, or along the part of it that is a side of a smaller neighbour. Such a place is rounded once, for
//      both cells beside it. So the sides of cells in what is lit run back and forth between the same places, and are left out.
//      Each image in a cell winds once around what it covers, and each shadow once the other way around what it
//      covers of that.
// Complexity: O(n log n) for n sides and borders, and O(k^2) for k conditions in a cell.
#pragma once

#include <unordered_set>
#include <vector>

#include "reflect/regions/image_place.h"
#include "reflect/smooth/lit_cell.h"

namespace sightline::inline reflect {

struct CellSide {
  ImagePoint first;  // in sweep order
  ImagePoint second;
  friend constexpr bool operator==(const CellSide&, const CellSide&) = default;
};

[[nodiscard]] CellSide side_between(const ImagePoint& p, const ImagePoint& q);

struct CellSideHash {
  [[nodiscard]] std::size_t operator()(const CellSide& side) const;
};
using CellSides = std::unordered_set<CellSide, CellSideHash>;

// Returns the place in the middle where it is a grid point.
[[nodiscard]] std::optional<ImagePoint> middle(const ImagePoint& p, const ImagePoint& q);

[[nodiscard]] RegionBorder border_of_cells(const std::vector<LitCell>& cells, const CellSides& halved);

}  // namespace sightline::inline reflect
