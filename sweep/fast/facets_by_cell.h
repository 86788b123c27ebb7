// The facets of each cell, where a cell can have a cover.
//
// In:  the cells of each facet. Out: per cell how many facets may be over its centre, up to two; and the facets that
//      touch those with two, in no order: where there are fewer, no second sheet is looked for.
// Complexity: O(n) in facets and their cells.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/numbers/grouping.h"
#include "sweep/fast/facet_cells.h"

namespace sightline::inline sweep {

[[nodiscard]] std::vector<std::uint8_t> count_over_centre(const FacetCells& cells, const CellGrid& grid,
                                                          std::size_t facets);

struct CellFacet {
  FacetId facet;
  bool over_centre = false;
};

[[nodiscard]] Grouping<CellFacet> facets_by_cell(const FacetCells& cells, const std::vector<std::uint8_t>& over_centre,
                                                 std::size_t facets);

}  // namespace sightline::inline sweep
