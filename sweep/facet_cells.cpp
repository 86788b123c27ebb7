#include "sweep/facet_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/parallel.h"
#include "sweep/facet_outline.h"

namespace sightline {
namespace {

// Points that are two grid units apart at least stay on their sides when corners are rounded.
constexpr double margin = 2;

// The products of a cross product of differences are off by less than this part of their absolute values.
constexpr double product_error = 0x1p-50;

// An edge as a line: where points lie across it, and how far a cell reaches.
struct Line {
  double x = 0;
  double y = 0;
  double dx = 0;
  double dy = 0;
  double reach = 0;  // of a cell, from its centre
  double slack = 0;  // what two grid units amount to

  Line() = default;
  Line(const ImagePoint& a, const ImagePoint& b, double half_cell)
      : x(static_cast<double>(a.x)),
        y(static_cast<double>(a.y)),
        dx(static_cast<double>(b.x - a.x)),
        dy(static_cast<double>(b.y - a.y)),
        reach((std::fabs(dx) + std::fabs(dy)) * half_cell),
        slack((std::fabs(dx) + std::fabs(dy)) * margin) {}

  struct Across {
    double value = 0;  // positive to the left
    double error = 0;
  };
  [[nodiscard]] Across across(double px, double py) const {
    const double left = dx * (py - y);
    const double right = dy * (px - x);
    return {left - right, product_error * (std::fabs(left) + std::fabs(right))};
  }
};

// A triangle against cells: they are apart where an edge's line parts them (the box's own axes are its cell range).
class TriangleInCells {
 public:
  TriangleInCells(std::span<const ImagePoint> corners, const CellGrid& grid)
      : half_cell_(static_cast<double>(grid.cell_size()) / 2) {
    for (std::size_t i = 0; i < 3; ++i) lines_[i] = Line(corners[i], corners[(i + 1) % 3], half_cell_);
    const auto opposite = lines_[0].across(static_cast<double>(corners[2].x), static_cast<double>(corners[2].y));
    turn_ = opposite.value < 0 ? -1 : 1;
    width_ = std::fabs(opposite.value) + opposite.error;
  }

  [[nodiscard]] bool misses(double x, double y) const {
    return std::ranges::any_of(lines_, [&](const Line& line) {
      const auto at = line.across(x, y);
      const double inwards = turn_ * at.value;
      const double apart = line.reach + line.slack + at.error;
      return inwards < -apart || inwards > width_ + apart;
    });
  }

  [[nodiscard]] bool is_over(double x, double y) const {
    return std::ranges::all_of(lines_, [&](const Line& line) {
      const auto at = line.across(x, y);
      return turn_ * at.value > line.slack + at.error;
    });
  }

 private:
  std::array<Line, 3> lines_;
  double half_cell_;
  double turn_ = 1;   // +1 where the corners run counter-clockwise
  double width_ = 0;  // of the triangle across each of its edges: twice its area
};

// Only of a polygon that turns one way: then being inside all its edges' lines is being inside.
bool is_over(std::span<const ImagePoint> outline, double turn, const ImagePoint& p) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Line line(outline[i], outline[i + 1 == outline.size() ? 0 : i + 1], 0);
    const auto at = line.across(static_cast<double>(p.x), static_cast<double>(p.y));
    if (!(turn * at.value > line.slack + at.error)) return false;
  }
  return true;
}

template <class Visit>
void for_each_cell_of_triangle(std::span<const ImagePoint> corners, const CellGrid& grid, Visit visit) {
  const TriangleInCells triangle(corners, grid);
  const CellRange range = grid.range_of(corners);
  const bool narrow = range.is_narrow();
  CellGrid::for_each(range, [&](unsigned column, unsigned row) {
    const ImagePoint centre = grid.centre(column, row);
    const auto x = static_cast<double>(centre.x);
    const auto y = static_cast<double>(centre.y);
    if (narrow || !triangle.misses(x, y)) visit(FacetCell(grid.cell(column, row), triangle.is_over(x, y)));
    return true;
  });
}

// Going through all cells of the bounding box pays up to here.
bool is_small(const CellRange& range) { return (range.right - range.left + 1) * (range.top - range.bottom + 1) <= 16; }

void add_cells(const ProjectedScene& scene, FacetId f, const CellGrid& grid, std::vector<FacetCell>& cells) {
  const FacetOutline outline(scene, f);
  const auto points = outline.points();
  if (points.size() == 3 && is_small(grid.range_of(points))) {
    for_each_cell_of_triangle(points, grid, [&](FacetCell cell) { cells.push_back(cell); });
    return;
  }
  const double turn = scene.facing[f.index()] == Facing::back ? -1 : 1;
  grid.for_each_in_polygon(points, [&](unsigned column, unsigned row) {
    cells.emplace_back(grid.cell(column, row), is_over(points, turn, grid.centre(column, row)));
    return true;
  });
}

}  // namespace

FacetCells::FacetCells(const ProjectedScene& scene, const CellGrid& grid, const std::vector<std::uint8_t>& hidden)
    : begin_(scene.status.size() + 1, 0) {
  std::vector<std::vector<FacetCell>> parts(range_count(scene.status.size()));
  parallel_for_ranges(scene.status.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
    std::vector<FacetCell>& part = parts[range];
    for (std::size_t f = begin; f < end; ++f) {
      const std::size_t before = part.size();
      if (scene.status[f] == Status::in_view && hidden[f] == 0) add_cells(scene, FacetId(f), grid, part);
      begin_[f + 1] = static_cast<std::uint32_t>(part.size() - before);
    }
  });
  for (std::size_t f = 1; f < begin_.size(); ++f) begin_[f] += begin_[f - 1];
  cells_.reserve(begin_.back());
  for (const auto& part : parts) cells_.insert(cells_.end(), part.begin(), part.end());
}

}  // namespace sightline
