#include "sweep/fast/large_covers.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/parallel.h"
#include "sweep/fast/cell_grid.h"

namespace sightline::inline sweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int highest_cell_level = 8;
constexpr int levels_of_tile = 3;  // so that it has 8 x 8 cells

// A facet covers cells only where it is some of them wide.
constexpr unsigned least_width = 4;

// How far at most a cell's points are from both ends of an edge, both ways added up, and twice the spread.
double far_from(const ImagePoint& a, const ImagePoint& b, const ImagePoint& centre, double half, double spread) {
  const auto way = [&](const ImagePoint& p) {
    return std::fabs(static_cast<double>(centre.x - p.x)) + std::fabs(static_cast<double>(centre.y - p.y));
  };
  return way(a) + way(b) + 4 * half + 2 * spread;
}

class LargeCovers {
 public:
  LargeCovers(const ProjectedScene& scene, const CellSides& sides, const std::vector<DepthRange>& depths)
      : scene_(scene),
        sides_(sides),
        depths_(depths),
        cells_(scene.grid_bits, cell_level_, spread_of(scene)),
        tiles_(scene.grid_bits, cell_level_ - levels_of_tile, spread_of(scene)),
        behind_cell_(cells_.cell_count(), infinity),
        behind_tile_(tiles_.cell_count(), infinity) {}

  // The nearest come first, so that they hide what would cover less. What is hidden by some stays hidden by all.
  std::vector<std::uint8_t> hidden() {
    std::vector<std::uint8_t> hidden(scene_.status.size(), 0);
    const std::vector<FacetId> large = large_facets();
    if (large.empty()) return hidden;
    for (const FacetId f : large) {
      const FacetOutline outline(scene_, f);
      hidden[f.index()] = is_hidden(f, outline) ? 1 : 0;
      if (hidden[f.index()] == 0) cover(f, outline);
    }
    parallel_for_each(hidden.size(), [&](std::size_t f) {
      if (scene_.status[f] != FacetStatus::in_view || hidden[f] != 0) return;
      hidden[f] = is_hidden(FacetId(f), FacetOutline(scene_, FacetId(f))) ? 1 : 0;
    });
    return hidden;
  }

 private:
  [[nodiscard]] std::vector<FacetId> large_facets() const {
    std::vector<std::uint8_t> flags(scene_.status.size(), 0);
    parallel_for_each(flags.size(), [&](std::size_t f) {
      flags[f] = scene_.status[f] == FacetStatus::in_view && is_large(FacetId(f)) ? 1 : 0;
    });
    std::vector<FacetId> large;
    for (std::size_t f = 0; f < flags.size(); ++f) {
      if (flags[f] != 0) large.emplace_back(f);
    }
    std::ranges::sort(large, {}, [this](FacetId f) { return std::pair(depths_[f.index()].farthest, f); });
    return large;
  }

  [[nodiscard]] bool is_large(FacetId f) const {
    const CellRange range = cells_.range_of(FacetOutline(scene_, f).points());
    return range.right - range.left >= static_cast<int>(least_width) &&
           range.top - range.bottom >= static_cast<int>(least_width);
  }

  [[nodiscard]] bool is_hidden(FacetId f, const FacetOutline& outline) const {
    const double nearest = depths_[f.index()].nearest;
    const auto behind_tiles = [&](unsigned column, unsigned row) {
      return nearest > behind_tile_[tiles_.cell(column, row)];
    };
    const auto behind_cells = [&](unsigned column, unsigned row) {
      return nearest > behind_cell_[cells_.cell(column, row)];
    };
    return tiles_.for_each_in_polygon(outline.points(), behind_tiles) ||
           cells_.for_each_in_polygon(outline.points(), behind_cells);
  }

  void cover(FacetId f, const FacetOutline& outline) {
    const double farthest = depths_[f.index()].farthest;
    cells_.for_each_in_polygon(outline.points(), [&](unsigned column, unsigned row) {
      double& behind = behind_cell_[cells_.cell(column, row)];
      if (farthest < behind && covers(f, outline, cells_.centre(column, row))) behind = farthest;
      return true;
    });
    tiles_.for_each_in_polygon(outline.points(), [&](unsigned column, unsigned row) {
      update_tile(column, row);
      return true;
    });
  }

  // What lies behind all cells of a tile lies behind the tile.
  void update_tile(unsigned column, unsigned row) {
    constexpr unsigned across = 1U << levels_of_tile;
    double behind = -infinity;
    for (unsigned y = row * across; y < (row + 1) * across; ++y) {
      for (unsigned x = column * across; x < (column + 1) * across; ++x) {
        behind = std::max(behind, behind_cell_[cells_.cell(x, y)]);
      }
    }
    behind_tile_[tiles_.cell(column, row)] = behind;
  }

  // Returns whether all edges inside the window certainly pass the cell on the left of it as the facet turns: then the
  // facet's polygon covers it. The products are off by less than 2^-50 of their absolute values; with ends that are off by a
  // spread s, the cross product is off by less than s times how far, both ways added up, the cell's points are from them, and
  // 2 s^2.
  [[nodiscard]] bool covers(FacetId f, const FacetOutline& of_f, const ImagePoint& centre) const {
    const auto outline = of_f.points();
    const double spread = cells_.spread();
    const double turn = scene_.facing[f.index()] == FacetFacing::back ? -1 : 1;
    const double half = static_cast<double>(cells_.cell_size()) / 2;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const ImagePoint& a = outline[i];
      const std::size_t next = i + 1 == outline.size() ? 0 : i + 1;
      const ImagePoint& b = outline[next];
      const auto dx = static_cast<double>(b.x - a.x);
      const auto dy = static_cast<double>(b.y - a.y);
      const double left = dx * static_cast<double>(centre.y - a.y);
      const double right = dy * static_cast<double>(centre.x - a.x);
      double reach = half * (std::fabs(dx) + std::fabs(dy));
      if (spread > 0) reach += spread * far_from(a, b, centre, half, spread);
      const bool passes =
          turn * (left - right) > reach * (1 + 0x1p-40) + 0x1p-40 * (std::fabs(left) + std::fabs(right));
      if (!passes && !sides_.is_on_border(of_f.ids()[i], of_f.ids()[next])) return false;
    }
    return true;
  }

  const ProjectedScene& scene_;
  const CellSides& sides_;
  const std::vector<DepthRange>& depths_;
  const int cell_level_ = std::clamp(highest_level_for(scene_.status.size()), levels_of_tile, highest_cell_level);
  const CellGrid cells_;
  const CellGrid tiles_;
  std::vector<double> behind_cell_;  // what lies deeper than this is hidden there
  std::vector<double> behind_tile_;
};

}  // namespace

std::vector<std::uint8_t> hidden_behind_large_facets(const ProjectedScene& scene, const CellSides& sides,
                                                     const std::vector<DepthRange>& depths) {
  return LargeCovers(scene, sides, depths).hidden();
}

}  // namespace sightline::inline sweep
