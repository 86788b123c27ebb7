#include "sweep/bands/bands.h"

#include <algorithm>
#include <atomic>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/parallel.h"

namespace sightline::inline sweep {
namespace {

using BandSet = std::uint64_t;
static_assert(8 * sizeof(BandSet) == most_bands);

class BandMaker {
 public:
  BandMaker(const SceneInCells& in, const std::vector<Role>& roles, std::size_t count)
      : mesh_(in.mesh()),
        roles_(roles),
        grid_(in.grid),
        cells_(in.cells),
        count_(std::clamp<std::size_t>(count, 1, most_bands)) {
    result_.swept.resize(count_);
  }

  Bands make() {
    part_open_facets();
    find_swept();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_open(std::size_t f) const { return roles_[f] == Role::open; }

  // Facets are parted by the highest row of cells that their surface touches, so that bands have about as many open
  // facets each.
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

  // Each surface, named by its first facet, has its highest row.
  [[nodiscard]] std::vector<std::uint32_t> top_rows() const {
    std::vector<std::uint32_t> row(mesh_.facet_count(), 0);
    parallel_for_each(row.size(), [&](std::size_t surface) {
      if (surface_of(mesh_, FacetId(surface)).index() != surface) return;
      const std::size_t end = end_of_surface(mesh_, FacetId(surface)).index();
      for (std::size_t f = surface; f < end; ++f) {
        if (is_open(f)) row[surface] = std::max(row[surface], top_row(FacetId(f)));
      }
    });
    return row;
  }

  [[nodiscard]] std::uint32_t top_row(FacetId f) const {
    std::uint32_t top = 0;
    for (const FacetCell& cell : cells_.of(f)) top = std::max(top, cell.cell() / grid_.side());
    return top;
  }

  // Returns, per cell, the bands of the open facets that touch it.
  [[nodiscard]] std::vector<BandSet> open_in_cells() const {
    std::vector<BandSet> open(grid_.cell_count(), 0);
    parallel_for_each(mesh_.facet_count(), [&](std::size_t f) {
      if (!is_open(f)) return;
      for (const FacetCell& cell : cells_.of(FacetId(f)))
        std::atomic_ref(open[cell.cell()]).fetch_or(set_of_band(f), std::memory_order_relaxed);
    });
    return open;
  }

  // Precondition: the facet is open.
  [[nodiscard]] BandSet set_of_band(std::size_t f) const { return BandSet{1} << result_.band_of[f].value; }

  void find_swept() {
    const std::vector<BandSet> open_in_cell = open_in_cells();
    std::vector<BandSet> bands_of(mesh_.facet_count(), 0);
    parallel_for_each(bands_of.size(), [&](std::size_t f) {
      if (roles_[f] == Role::absent || roles_[f] == Role::hidden) return;
      if (is_open(f)) bands_of[f] = set_of_band(f);
      for (const FacetCell& cell : cells_.of(FacetId(f))) bands_of[f] |= open_in_cell[cell.cell()];
    });
    parallel_for_each(count_, 1, [&](std::size_t band) {
      for (std::size_t f = 0; f < bands_of.size(); ++f) {
        if ((bands_of[f] >> band & 1U) != 0) result_.swept[band].emplace_back(f);
      }
    });
  }

  const CutMesh& mesh_;
  const std::vector<Role>& roles_;
  const CellGrid& grid_;
  const FacetCells& cells_;
  const std::size_t count_;
  Bands result_;
};

// So many open facets make up for what a band costs.
constexpr std::size_t open_facets_in_a_band = 10000;
// What reaches from one band into the next is swept twice, so a band should be so many times higher than a facet.
constexpr double band_height_in_facets = 20;
// But so many bands are shared out, if no more than this part of what they sweep is swept twice.
constexpr std::size_t bands_to_share_out = 4;
constexpr double most_repeated = 0.25;

unsigned rows_of(std::span<const FacetCell> cells, const CellGrid& grid) {
  if (cells.empty()) return 0;
  const auto [low, high] = std::ranges::minmax(cells, {}, &FacetCell::cell);
  return high.cell() / grid.side() - low.cell() / grid.side() + 1;
}

std::size_t band_count(const SceneInCells& in, const std::vector<Role>& roles) {
  std::atomic<std::size_t> open = 0;
  std::atomic<std::size_t> rows = 0;
  parallel_for_each(roles.size(), [&](std::size_t f) {
    if (roles[f] != Role::open) return;
    open.fetch_add(1, std::memory_order_relaxed);
    rows.fetch_add(rows_of(in.cells.of(FacetId(f)), in.grid), std::memory_order_relaxed);
  });
  if (open == 0) return 1;
  const double mean_rows = static_cast<double>(rows) / static_cast<double>(open);
  const auto by_height = static_cast<std::size_t>(in.grid.side() / (band_height_in_facets * std::max(mean_rows, 1.0)));
  return std::min(1 + open / open_facets_in_a_band, std::max(bands_to_share_out, by_height));
}

// Returns whether too many of the facets that bands sweep are swept by more than one.
bool repeat_too_much(const Bands& bands, std::size_t facets) {
  std::vector<std::uint8_t> is_swept(facets, 0);
  std::size_t swept = 0;
  for (const std::vector<FacetId>& band : bands.swept) {
    swept += band.size();
    for (const FacetId f : band) is_swept[f.index()] = 1;
  }
  const auto once = static_cast<double>(std::ranges::count(is_swept, 1));
  return static_cast<double>(swept) > (1 + most_repeated) * once;
}

}  // namespace

Bands make_bands(const SceneInCells& in, const std::vector<Role>& roles, std::size_t count) {
  return BandMaker(in, roles, count).make();
}

Bands make_bands(const SceneInCells& in, const std::vector<Role>& roles) {
  std::size_t count = band_count(in, roles);
  Bands bands = make_bands(in, roles, count);
  while (count > 1 && repeat_too_much(bands, roles.size())) bands = make_bands(in, roles, count /= 2);
  return bands;
}

}  // namespace sightline::inline sweep
