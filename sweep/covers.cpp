#include "sweep/covers.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>

#include "geometry/parallel.h"
#include "sweep/depth_order.h"

namespace sightline {
namespace {

// After so many sheets over a cell's centre that do not cover it, no more are tried.
constexpr std::size_t most_failures = 4;

// A facet that touches a cell.
struct CellFacet {
  FacetId facet;
  bool over_centre = false;
};

// Per cell with several facets over its centre the facets that touch it.
class CellFacets {
 public:
  CellFacets(const FacetCells& cells, const CellGrid& grid, const std::vector<std::uint8_t>& hidden)
      : begin_(grid.cell_count() + 1, 0) {
    const std::vector<std::uint8_t> wanted = cells_with_sheets(cells, grid, hidden);
    const auto for_each_pair = [&](auto visit) {
      for (std::size_t f = 0; f < hidden.size(); ++f) {
        if (hidden[f] != 0) continue;
        for (const FacetCell& cell : cells.of(FacetId(f))) {
          if (wanted[cell.cell()] > 1) visit(cell.cell(), CellFacet{FacetId(f), cell.over_centre()});
        }
      }
    };
    for_each_pair([this](CellIndex cell, const CellFacet&) { ++begin_[cell + 1]; });
    for (std::size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
    facets_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for_each_pair([&](CellIndex cell, const CellFacet& facet) { facets_[next[cell]++] = facet; });
  }

  [[nodiscard]] std::span<const CellFacet> in_cell(CellIndex cell) const {
    return std::span(facets_).subspan(begin_[cell], begin_[cell + 1] - begin_[cell]);
  }

 private:
  // Per cell how many facets are over its centre, up to two.
  static std::vector<std::uint8_t> cells_with_sheets(const FacetCells& cells, const CellGrid& grid,
                                                     const std::vector<std::uint8_t>& hidden) {
    std::vector<std::uint8_t> sheets(grid.cell_count(), 0);
    for (std::size_t f = 0; f < hidden.size(); ++f) {
      if (hidden[f] != 0) continue;
      for (const FacetCell& cell : cells.of(FacetId(f))) {
        if (cell.over_centre() && sheets[cell.cell()] < 2) ++sheets[cell.cell()];
      }
    }
    return sheets;
  }

  std::vector<std::uint32_t> begin_;
  std::vector<CellFacet> facets_;
};

// Whether an edge certainly misses a square: its line passes the centre further away than the corners are. The square is
// taken two units larger on each side, so that what covers its rounded image covers it exactly, too; the products are off by less
// than 2^-50 of their absolute values.
bool misses(const ImagePoint& a, const ImagePoint& b, const ImagePoint& centre, std::int64_t cell_size) {
  const double half = static_cast<double>(cell_size) / 2 + 2;
  const auto ax = static_cast<double>(a.x - centre.x);
  const auto ay = static_cast<double>(a.y - centre.y);
  const auto bx = static_cast<double>(b.x - centre.x);
  const auto by = static_cast<double>(b.y - centre.y);
  if (std::min(ax, bx) > half || std::max(ax, bx) < -half) return true;
  if (std::min(ay, by) > half || std::max(ay, by) < -half) return true;
  const double left = ax * by;
  const double right = ay * bx;
  const double reach = half * (std::fabs(bx - ax) + std::fabs(by - ay));
  return std::fabs(left - right) > reach * (1 + 0x1p-40) + 0x1p-40 * (std::fabs(left) + std::fabs(right));
}

// Looks at some of the cells, and counts for each facet in how many of them it is hidden.
class CoverFinder {
 public:
  CoverFinder(const Mesh& mesh, const ProjectedScene& scene, const std::vector<DepthRange>& depths,
              const Continuation& continuation, const CellGrid& grid, const CellFacets& facets)
      : mesh_(mesh),
        scene_(scene),
        depths_(depths),
        continuation_(continuation),
        grid_(grid),
        facets_(facets),
        order_(mesh, scene),
        mark_(scene.status.size(), 0),
        hidden_cells_(scene.status.size(), 0) {}

  void look_at_row(unsigned row) {
    for (unsigned column = 0; column < grid_.side(); ++column) {
      cell_ = grid_.cell(column, row);
      centre_ = grid_.centre(column, row);
      if (!facets_.in_cell(cell_).empty()) look_at_cell();
    }
  }

  [[nodiscard]] const std::vector<std::uint32_t>& hidden_cells() const { return hidden_cells_; }

 private:
  void look_at_cell() {
    find_over_centre();
    const FacetId cover = find_cover();
    if (!cover.valid()) return;
    const std::uint32_t cover_mark = marks_;
    const std::uint32_t behind_mark = ++marks_;
    for (const FacetId f : over_centre_) {
      if (mark_[f.index()] < cover_mark && is_behind(f, cover)) flood_behind(f, cover_mark, behind_mark);
    }
    for (const auto& [f, over_centre] : facets_.in_cell(cell_)) {
      const bool behind = mark_[f.index()] == behind_mark || depths_[f.index()].nearest > cover_farthest_ ||
                          (cover_size_ == 1 && f != cover && is_behind(f, cover));
      hidden_cells_[f.index()] += behind ? 1 : 0;
    }
  }

  void find_over_centre() {
    over_centre_.clear();
    for (const auto& [f, over_centre] : facets_.in_cell(cell_)) {
      if (over_centre) over_centre_.push_back(f);
    }
    std::ranges::sort(over_centre_, {}, [this](FacetId f) { return std::pair(depths_[f.index()].farthest, f); });
  }

  // A facet over the centre whose sheet covers the cell, and no other's that is tried lies before it; the sheet's facets have
  // the last mark.
  FacetId find_cover() {
    FacetId cover;
    std::size_t failed = 0;
    for (const FacetId f : over_centre_) {
      if (cover.valid() && !(is_known_order(f, cover) && order_.nearer(f, cover))) continue;
      if (flood_cover(f)) {
        cover = f;
      } else if (++failed == most_failures) {
        break;
      }
    }
    if (cover.valid()) flood_cover(cover);
    return cover;
  }

  // False where the sheet meets a contour edge in the cell.
  bool flood_cover(FacetId first) {
    ++marks_;
    cover_size_ = 0;
    cover_farthest_ = -std::numeric_limits<double>::infinity();
    begin_flood(first, marks_);
    while (!flood_.empty()) {
      const FacetId f = next_of_flood();
      ++cover_size_;
      cover_farthest_ = std::max(cover_farthest_, depths_[f.index()].farthest);
      for (const EdgeId e : continuation_.edges_of(scene_, f)) {
        if (e.valid() && misses_cell(e)) continue;
        if (!e.valid() || continuation_.is_contour(e)) return false;
        add_to_flood(across(e, f), marks_);
      }
    }
    return true;
  }

  // Both are over one place, even before they were rounded: the cell's centre, or anywhere in the cell where the cover is
  // one facet.
  [[nodiscard]] bool is_behind(FacetId f, FacetId cover) {
    if (depths_[f.index()].nearest > cover_farthest_) return true;
    return is_known_order(f, cover) && order_.nearer(cover, f);
  }

  [[nodiscard]] bool is_known_order(FacetId f, FacetId g) const { return !touches(f) && !touches(g); }

  [[nodiscard]] bool touches(FacetId f) const { return mesh_.touched[f.index()] != 0; }

  void flood_behind(FacetId first, std::uint32_t cover_mark, std::uint32_t mark) {
    if (touches(first)) return;
    begin_flood(first, mark);
    while (!flood_.empty()) {
      const FacetId f = next_of_flood();
      for (const EdgeId e : continuation_.edges_of(scene_, f)) {
        if (!e.valid() || continuation_.is_contour(e) || misses_cell(e)) continue;
        const FacetId next = across(e, f);
        if (mark_[next.index()] != cover_mark && !touches(next)) add_to_flood(next, mark);
      }
    }
  }

  void begin_flood(FacetId first, std::uint32_t mark) {
    flood_.clear();
    mark_[first.index()] = mark;
    flood_.push_back(first);
  }

  FacetId next_of_flood() {
    const FacetId f = flood_.back();
    flood_.pop_back();
    return f;
  }

  void add_to_flood(FacetId f, std::uint32_t mark) {
    if (mark_[f.index()] == mark) return;
    mark_[f.index()] = mark;
    flood_.push_back(f);
  }

  [[nodiscard]] bool misses_cell(EdgeId e) const {
    const SceneEdge& edge = scene_.edge(e);
    return misses(scene_.point(edge.top), scene_.point(edge.bottom), centre_, grid_.cell_size());
  }

  [[nodiscard]] FacetId across(EdgeId e, FacetId f) const {
    const Neighbours& neighbours = continuation_.across(e);
    return neighbours.left == f ? neighbours.right : neighbours.left;
  }

  const Mesh& mesh_;
  const ProjectedScene& scene_;
  const std::vector<DepthRange>& depths_;
  const Continuation& continuation_;
  const CellGrid& grid_;
  const CellFacets& facets_;
  DepthOrder order_;
  std::vector<std::uint32_t> mark_;          // per facet: the last flood that reached it
  std::vector<std::uint32_t> hidden_cells_;  // per facet: in how many cells it is hidden
  std::uint32_t marks_ = 0;

  // Of the current cell:
  CellIndex cell_ = 0;
  ImagePoint centre_;
  std::vector<FacetId> over_centre_;
  std::size_t cover_size_ = 0;  // in facets
  double cover_farthest_ = 0;
  std::vector<FacetId> flood_;
};

}  // namespace

std::vector<std::uint8_t> hidden_behind_covers(const Mesh& mesh, const ProjectedScene& scene,
                                               const std::vector<DepthRange>& depths, const Continuation& continuation,
                                               const CellGrid& grid, const FacetCells& cells,
                                               std::vector<std::uint8_t> hidden) {
  const CellFacets facets(cells, grid, hidden);
  tbb::enumerable_thread_specific<CoverFinder> finders(
      [&] { return CoverFinder(mesh, scene, depths, continuation, grid, facets); });
  constexpr std::size_t rows_in_a_row = 8;
  parallel_for_each(grid.side(), rows_in_a_row,
                    [&](std::size_t row) { finders.local().look_at_row(static_cast<unsigned>(row)); });
  parallel_for_each(hidden.size(), [&](std::size_t f) {
    std::size_t hidden_cells = 0;
    for (const CoverFinder& finder : finders) hidden_cells += finder.hidden_cells()[f];
    if (hidden_cells > 0 && hidden_cells == cells.of(FacetId(f)).size()) hidden[f] = 1;
  });
  return hidden;
}

}  // namespace sightline
