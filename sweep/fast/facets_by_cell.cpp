#include "sweep/fast/facets_by_cell.h"

#include <atomic>

#include "geometry/numbers/parallel.h"

namespace sightline::inline sweep {

std::vector<std::uint8_t> count_over_centre(const FacetCells& cells, const CellGrid& grid, std::size_t facets) {
  std::vector<std::uint8_t> count(grid.cell_count(), 0);
  parallel_for_each(facets, [&](std::size_t f) {
    for (const FacetCell& cell : cells.of(FacetId(f))) {
      std::atomic_ref of_cell(count[cell.cell()]);
      std::uint8_t before = of_cell.load(std::memory_order_relaxed);
      while (cell.over_centre() && before < 2 && !of_cell.compare_exchange_weak(before, before + 1)) continue;
    }
  });
  return count;
}

Grouping<CellFacet> facets_by_cell(const FacetCells& cells, const std::vector<std::uint8_t>& over_centre,
                                   std::size_t facets) {
  return Grouping<CellFacet>(over_centre.size(), [&](const auto& visit) {
    parallel_for_each(facets, [&](std::size_t f) {
      for (const FacetCell& cell : cells.of(FacetId(f))) {
        if (over_centre[cell.cell()] > 1) visit(cell.cell(), CellFacet{FacetId(f), cell.over_centre()});
      }
    });
  });
}

}  // namespace sightline::inline sweep
