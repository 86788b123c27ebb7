// Per facet the cells of the image that it touches.
//
// In:  a projected scene, its proper facets (continuation.h), a grid of cells, and facets that are known to be hidden.
// Out: per facet in view that is not among these the cells that its rounded polygon touches, each with whether the
//      polygon, its border included, is over the cell's centre; exactly so of a proper facet, any other one may be over
//      every centre. A few cells more than it touches are named, never one too few.
// Complexity: O(n) and the cells.
#pragma once

#include <span>
#include <vector>

#include "geometry/projection/projected_scene.h"
#include "sweep/fast/cell_grid.h"
#include "sweep/fast/cell_sides.h"
#include "sweep/fast/continuation.h"

namespace sightline::inline sweep {

class FacetCell {
 public:
  FacetCell(CellIndex cell, bool over_centre) : bits_(cell << 1 | (over_centre ? 1U : 0U)) {}
  [[nodiscard]] CellIndex cell() const { return bits_ >> 1; }
  [[nodiscard]] bool over_centre() const { return (bits_ & 1U) != 0; }

 private:
  std::uint32_t bits_;
};

class FacetCells {
 public:
  FacetCells(const ProjectedScene& scene, const CellSides& sides, const Continuation& continuation,
             const CellGrid& grid, const std::vector<std::uint8_t>& hidden);

  [[nodiscard]] std::span<const FacetCell> of(FacetId f) const {
    return std::span(cells_).subspan(begin_[f.index()], begin_[f.index() + 1] - begin_[f.index()]);
  }

 private:
  std::vector<std::uint32_t> begin_;  // per facet and one more
  std::vector<FacetCell> cells_;
};

}  // namespace sightline::inline sweep
