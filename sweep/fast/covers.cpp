#include "sweep/fast/covers.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/grouping.h"
#include "geometry/numbers/parallel.h"
#include "sweep/plain/depth_order.h"
#include "sweep/unrounded/swap_edges.h"

namespace sightline::inline sweep {
namespace {

// After so many sheets over a cell's centre that do not cover it, no more are tried.
constexpr std::size_t most_failures = 4;

// Returns whether an edge certainly misses a square: its line passes the centre further away than the corners are. The
// products are off by less than 2^-50 of their absolute values.
bool misses(const ImagePoint& a, const ImagePoint& b, const ImagePoint& centre, const CellGrid& grid) {
  const double half = static_cast<double>(grid.cell_size()) / 2 + grid.spread();
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

bool boxes_are_apart(std::span<const ImagePoint> a, std::span<const ImagePoint> b, int spread) {
  const auto apart = [&](auto coordinate) {
    const auto [a_low, a_high] = std::ranges::minmax(a, {}, coordinate);
    const auto [b_low, b_high] = std::ranges::minmax(b, {}, coordinate);
    return coordinate(a_high) + 2 * spread <= coordinate(b_low) || coordinate(b_high) + 2 * spread <= coordinate(a_low);
  };
  return apart([](const ImagePoint& p) { return p.x; }) || apart([](const ImagePoint& p) { return p.y; });
}

// Returns whether all the points are on the outer side of an edge of a convex polygon with this turn, or on its line.
bool is_beyond_an_edge(const CellSides& sides, std::span<const PointId> points, std::span<const PointId> polygon,
                       Sign turn) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PointId next = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const auto is_outside = [&](PointId p) { return sides.orientation(polygon[i], next, p) * turn <= 0; };
    if (std::ranges::all_of(points, is_outside)) return true;
  }
  return false;
}

// Returns on which side of the line from a to b a point is that lies an infinitesimal step to the right of p, and one of a
// higher order above it: so never on it. Ids say whether a is higher than b, or else further left.
Sign side_beside(const CellSides& sides, PointId a, PointId b, const ImagePoint& p) {
  const Sign side = sides.orientation(a, b, p);
  return side != 0 ? side : a < b ? 1 : -1;
}

// Returns whether a convex polygon with this turn contains the point beside p: of polygons that lie side by side one does.
bool contains_beside(const CellSides& sides, std::span<const PointId> polygon, Sign turn, const ImagePoint& p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PointId next = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    if (polygon[i] != next && side_beside(sides, polygon[i], next, p) * turn < 0) return false;
  }
  return true;
}

// Returns, per cell, how many facets may be over its centre, up to two.
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

struct CellFacet {
  FacetId facet;
  bool over_centre = false;
};

// Returns the facets that touch the cells with two over their centre, in no order: where there are fewer, no second
// sheet is looked for.
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

// This looks at some of the cells, and counts for each facet in how many of them it is not in front.
class CoverFinder : private LocalOrder {
 public:
  CoverFinder(const SceneInCells& in, const Grouping<CellFacet>& facets, std::vector<std::uint8_t>& one_sheet)
      : scene_(in.scene),
        sides_(in.sides),
        depths_(in.depths),
        continuation_(in.continuation),
        grid_(in.grid),
        facets_(facets),
        one_sheet_(one_sheet),
        order_(in.scene, in.depths),
        swap_edges_(in.scene),
        mark_(in.hidden.size(), 0),
        hidden_cells_(in.hidden.size(), 0) {
    if (in.scene.is_unrounded()) order_.set_local_order(this);
  }
  CoverFinder(const CoverFinder&) = delete;
  CoverFinder& operator=(const CoverFinder&) = delete;

  void look_at_row(unsigned row) {
    for (unsigned column = 0; column < grid_.side(); ++column) {
      cell_ = grid_.cell(column, row);
      centre_ = grid_.centre(column, row);
      if (!facets_.of(cell_).empty()) look_at_cell();
    }
  }

  [[nodiscard]] const std::vector<std::uint32_t>& hidden_cells() const { return hidden_cells_; }

 private:
  void look_at_cell() {
    find_over_centre();
    if (!find_cover()) return;
    const std::size_t cover_size = in_front_.size();
    find_others();
    for (std::size_t i = 0; i < in_front_.size();) bring_forward(in_front_[i++]);
    for (const FacetId f : behind_) ++hidden_cells_[f.index()];
    one_sheet_[cell_] = in_front_.size() == cover_size && covers_once() ? 1 : 0;
  }

  // A sheet may wind around a vertex more than once, like a spiral staircase, and so cover the cell as often as it covers
  // the centre. Precondition: what is in front is the cover.
  [[nodiscard]] bool covers_once() const {
    return std::ranges::count_if(in_front_, [this](FacetId f) {
             return contains_beside(sides_, FacetOutline(scene_, f).ids(), turn_of(f), centre_);
           }) == 1;
  }

  // Returns how the outline of a proper facet turns in the image.
  [[nodiscard]] Sign turn_of(FacetId f) const { return scene_.facing[f.index()] == FacetFacing::back ? -1 : 1; }

  void find_over_centre() {
    over_centre_.clear();
    for (const auto& [f, over_centre] : facets_.of(cell_)) {
      if (over_centre && continuation_.is_proper(f)) over_centre_.push_back(f);
    }
    std::ranges::sort(over_centre_, {}, [this](FacetId f) { return std::pair(depths_[f.index()].farthest, f); });
  }

  // The cover is the sheet of a facet over the centre that covers the cell, where no other sheet that is tried lies
  // before it. Its facets are in front, and have the last mark.
  bool find_cover() {
    FacetId cover;
    std::size_t failed = 0;
    for (const FacetId f : over_centre_) {
      if (cover.valid() && !order_.nearer(f, cover)) continue;
      if (flood_cover(f)) {
        cover = f;
      } else if (++failed == most_failures) {
        break;
      }
    }
    return cover.valid() && flood_cover(cover);
  }

  // Returns false where the sheet meets a contour edge in the cell.
  bool flood_cover(FacetId first) {
    ++marks_;
    cover_farthest_ = -std::numeric_limits<double>::infinity();
    in_front_.clear();
    add_to_cover(first);
    for (std::size_t i = 0; i < in_front_.size();) {
      const FacetId f = in_front_[i++];
      for (const EdgeId e : continuation_.edges_of(scene_, f)) {
        if (e.valid() && misses_cell(e)) continue;
        if (!e.valid() || continuation_.is_contour(e)) return false;
        add_to_cover(across(e, f));
      }
    }
    return true;
  }

  void add_to_cover(FacetId f) {
    if (mark_[f.index()] == marks_) return;
    mark_[f.index()] = marks_;
    in_front_.push_back(f);
    cover_farthest_ = std::max(cover_farthest_, depths_[f.index()].farthest);
  }

  // What is deeper than all of the cover is hidden; what else is not of the cover may be behind it.
  void find_others() {
    behind_.clear();
    for (const auto& [f, over_centre] : facets_.of(cell_)) {
      if (mark_[f.index()] == marks_) continue;
      if (depths_[f.index()].nearest > cover_farthest_) {
        ++hidden_cells_[f.index()];
      } else {
        behind_.push_back(f);
      }
    }
  }

  // What is not behind one that is in front is in front, too.
  void bring_forward(FacetId front) {
    const auto from = std::partition(behind_.begin(), behind_.end(), [&](FacetId f) { return is_behind(f, front); });
    in_front_.insert(in_front_.end(), from, behind_.end());
    behind_.erase(from, behind_.end());
  }

  [[nodiscard]] bool is_behind(FacetId f, FacetId front) {
    if (depths_[front.index()].farthest < depths_[f.index()].nearest) return true;
    const FacetOutline outline(scene_, f);
    const FacetOutline front_outline(scene_, front);
    return boxes_are_apart(outline.points(), front_outline.points(), grid_.spread()) || is_nearer_in_cell(front, f) ||
           is_beyond(outline, front, front_outline) || is_beyond(front_outline, f, outline);
  }

  [[nodiscard]] bool is_nearer_in_cell(FacetId f, FacetId g) {
    const DepthRelation relation = order_.relation(f, g);
    return relation.nearer && !relation.passes_through;
  }

  // Facets that pass through each other have one order in the cell where the line along which they change places certainly
  // misses it: the cell is a place known up to half its size.
  [[nodiscard]] DepthRelation relation_here(FacetId f, FacetId g) override {
    const EdgeId edge = swap_edges_.between(f, g);
    const auto window = [this](double spacings) { return std::ldexp(spacings, -scene_.grid_bits); };
    const CertifiedPlace cell{window(static_cast<double>(centre_.x)), window(static_cast<double>(centre_.y)),
                              window(static_cast<double>(grid_.cell_size()) / 2)};
    const auto side = certain_sign(distance_right_of(swap_edges_.all()[edge.index() - scene_.edge_count()], cell));
    return {side == swap_edges_.nearer_side(edge, f), !side};
  }

  [[nodiscard]] bool is_beyond(const FacetOutline& outline, FacetId f, const FacetOutline& of_f) const {
    return continuation_.is_proper(f) && is_beyond_an_edge(sides_, outline.ids(), of_f.ids(), turn_of(f));
  }

  [[nodiscard]] bool misses_cell(EdgeId e) const {
    const SceneEdge& edge = scene_.edge(e);
    return misses(scene_.point(edge.top), scene_.point(edge.bottom), centre_, grid_) ||
           sides_.is_on_border(edge.top, edge.bottom);
  }

  [[nodiscard]] FacetId across(EdgeId e, FacetId f) const {
    const Neighbours& neighbours = continuation_.across(e);
    return neighbours.left == f ? neighbours.right : neighbours.left;
  }

  const ProjectedScene& scene_;
  const CellSides& sides_;
  const std::vector<DepthRange>& depths_;
  const Continuation& continuation_;
  const CellGrid& grid_;
  const Grouping<CellFacet>& facets_;
  std::vector<std::uint8_t>& one_sheet_;
  DepthOrder order_;
  SwapEdges swap_edges_;
  std::vector<std::uint32_t> mark_;          // per facet: the last sheet that it was of
  std::vector<std::uint32_t> hidden_cells_;  // per facet: in how many cells it is not in front
  std::uint32_t marks_ = 0;

  // These belong to the current cell.
  CellIndex cell_ = 0;
  ImagePoint centre_;
  std::vector<FacetId> over_centre_;
  std::vector<FacetId> in_front_;
  std::vector<FacetId> behind_;
  double cover_farthest_ = 0;
};

}  // namespace

Covers find_covers(const SceneInCells& in) {
  const std::size_t facet_count = in.hidden.size();
  Covers covers{in.hidden, count_over_centre(in.cells, in.grid, facet_count)};
  const Grouping<CellFacet> facets = facets_by_cell(in.cells, covers.one_sheet, facet_count);
  std::ranges::replace(covers.one_sheet, 2, 0);
  tbb::enumerable_thread_specific<CoverFinder> finders([&] { return CoverFinder(in, facets, covers.one_sheet); });
  constexpr std::size_t rows_in_a_row = 8;
  parallel_for_each(in.grid.side(), rows_in_a_row,
                    [&](std::size_t row) { finders.local().look_at_row(static_cast<unsigned>(row)); });
  parallel_for_each(covers.hidden.size(), [&](std::size_t f) {
    std::size_t hidden_cells = 0;
    for (const CoverFinder& finder : finders) hidden_cells += finder.hidden_cells()[f];
    if (hidden_cells > 0 && hidden_cells == in.cells.of(FacetId(f)).size()) covers.hidden[f] = 1;
  });
  keep_surfaces_whole(in.scene, covers.hidden);
  return covers;
}

}  // namespace sightline::inline sweep
