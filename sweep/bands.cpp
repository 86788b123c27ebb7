#include "sweep/bands.h"

#include <algorithm>

#include "geometry/facet_plane.h"
#include "geometry/parallel.h"

namespace sightline {
namespace {

using BandSet = std::uint64_t;
static_assert(8 * sizeof(BandSet) == most_bands);

class BandMaker {
 public:
  BandMaker(const Mesh& mesh, const std::vector<Role>& roles, const CellGrid& grid, const FacetCells& cells,
            std::size_t count)
      : mesh_(mesh), roles_(roles), grid_(grid), cells_(cells), count_(std::clamp<std::size_t>(count, 1, most_bands)) {
    result_.swept.resize(count_);
  }

  Bands make() {
    part_open_facets();
    find_swept();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_open(std::size_t f) const { return roles_[f] == Role::open; }

  // By the highest row of cells that a facet's surface touches, so that bands have about as many open facets each.
  void part_open_facets() {
    const std::vector<std::uint32_t> row = top_rows();
    std::vector<std::size_t> in_row(grid_.side(), 0);
    std::size_t open = 0;
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
      if (!is_open(f)) continue;
      ++in_row[row[surface_of(mesh_, FacetId(f)).index()]];
      ++open;
    }
    std::vector<BandId> band_of_row;
    std::size_t before = 0;
    for (const std::size_t here : in_row) {
      band_of_row.emplace_back(std::min(count_ - 1, before * count_ / std::max<std::size_t>(open, 1)));
      before += here;
    }
    result_.band_of.resize(mesh_.facet_count());
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
      if (is_open(f)) result_.band_of[f] = band_of_row[row[surface_of(mesh_, FacetId(f)).index()]];
    }
  }

  // Per surface, named by its first facet.
  [[nodiscard]] std::vector<std::uint32_t> top_rows() const {
    std::vector<std::uint32_t> row(mesh_.facet_count(), 0);
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
      if (!is_open(f)) continue;
      std::uint32_t& top = row[surface_of(mesh_, FacetId(f)).index()];
      for (const FacetCell& cell : cells_.of(FacetId(f))) top = std::max(top, cell.cell() / grid_.side());
    }
    return row;
  }

  void find_swept() {
    std::vector<BandSet> open_in_cell(grid_.cell_count(), 0);
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
      if (!is_open(f)) continue;
      for (const FacetCell& cell : cells_.of(FacetId(f)))
        open_in_cell[cell.cell()] |= BandSet{1} << result_.band_of[f].value;
    }
    std::vector<BandSet> bands_of(mesh_.facet_count(), 0);
    parallel_for_each(bands_of.size(), [&](std::size_t f) {
      if (roles_[f] == Role::absent || roles_[f] == Role::hidden) return;
      if (is_open(f)) bands_of[f] = BandSet{1} << result_.band_of[f].value;
      for (const FacetCell& cell : cells_.of(FacetId(f))) bands_of[f] |= open_in_cell[cell.cell()];
    });
    parallel_for_each(count_, 1, [&](std::size_t band) {
      for (std::size_t f = 0; f < bands_of.size(); ++f) {
        if ((bands_of[f] >> band & 1U) != 0) result_.swept[band].emplace_back(f);
      }
    });
  }

  const Mesh& mesh_;
  const std::vector<Role>& roles_;
  const CellGrid& grid_;
  const FacetCells& cells_;
  const std::size_t count_;
  Bands result_;
};

}  // namespace

Bands make_bands(const Mesh& mesh, const std::vector<Role>& roles, const CellGrid& grid, const FacetCells& cells,
                 std::size_t count) {
  return BandMaker(mesh, roles, grid, cells, count).make();
}

}  // namespace sightline
