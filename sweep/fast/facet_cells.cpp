#include "sweep/fast/facet_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "geometry/numbers/parallel.h"

namespace sightline::inline sweep {
namespace {

// The products of a cross product of differences are off by less than this part of their absolute values.
constexpr double product_error = 0x1p-50;

// A line is an edge that says where points lie across it, and how far a cell reaches.
struct Line {
  ImagePoint a;
  ImagePoint b;
  double dx = 0;
  double dy = 0;
  double reach = 0;  // of a cell, from its centre

  Line() = default;
  // Precondition: the reach is that of a cell, with the spread of its ends.
  Line(const ImagePoint& from, const ImagePoint& to, double half_cell)
      : a(from),
        b(to),
        dx(static_cast<double>(b.x - a.x)),
        dy(static_cast<double>(b.y - a.y)),
        reach((std::fabs(dx) + std::fabs(dy)) * half_cell) {}

  struct Across {
    double value = 0;  // positive to the left
    double error = 0;
  };
  [[nodiscard]] Across across(const ImagePoint& p) const {
    const double left = dx * static_cast<double>(p.y - a.y);
    const double right = dy * static_cast<double>(p.x - a.x);
    return {left - right, product_error * (std::fabs(left) + std::fabs(right))};
  }
  // Returns +1 where p is certainly to the left, -1 where to the right. With ends that are off by a spread s, the cross
  // product is off by less than s times how far, both ways added up, p is from them, and 2 s^2.
  [[nodiscard]] Sign certain_side(const ImagePoint& p, int spread) const {
    const Across at = across(p);
    double error = at.error;
    if (spread > 0)
      error += spread * (static_cast<double>(distance(a, p) + distance(b, p)) + 2.0 * spread) * (1 + product_error);
    return std::fabs(at.value) > error ? (at.value > 0 ? 1 : -1) : 0;
  }
  [[nodiscard]] static std::int64_t distance(const ImagePoint& p, const ImagePoint& q) {
    return std::abs(p.x - q.x) + std::abs(p.y - q.y);
  }
};

// This tests a triangle against cells: they are apart where an edge's line parts them (the box's own axes are its cell
// range).
class TriangleInCells {
 public:
  TriangleInCells(std::span<const ImagePoint> corners, const CellGrid& grid) {
    const double half_cell = static_cast<double>(grid.cell_size()) / 2 + grid.spread();
    for (std::size_t i = 0; i < 3; ++i) lines_[i] = Line(corners[i], corners[(i + 1) % 3], half_cell);
    const auto opposite = lines_[0].across(corners[2]);
    turn_ = opposite.value < 0 ? -1 : 1;
    width_ = std::fabs(opposite.value) + opposite.error;
  }

  // The lines between the corners, each from one to the next.
  [[nodiscard]] std::span<const Line> lines() const { return lines_; }

  [[nodiscard]] bool misses(const ImagePoint& centre) const {
    return std::ranges::any_of(lines_, [&](const Line& line) {
      const auto at = line.across(centre);
      const double inwards = turn_ * at.value;
      const double apart = line.reach + at.error;
      return inwards < -apart || inwards > width_ + apart;
    });
  }

 private:
  std::array<Line, 3> lines_;
  double turn_ = 1;   // +1 where the corners run counter-clockwise
  double width_ = 0;  // of the triangle across each of its edges: twice its area
};

// Up to this size it pays to go through all cells of the bounding box.
bool is_small(const CellRange& range) { return (range.right - range.left + 1) * (range.top - range.bottom + 1) <= 16; }

class CellsOfFacets {
 public:
  CellsOfFacets(const ProjectedScene& scene, const CellSides& sides, const Continuation& continuation,
                const CellGrid& grid)
      : scene_(scene), sides_(sides), continuation_(continuation), grid_(grid) {}

  void add(FacetId f, std::vector<FacetCell>& cells) const {
    const FacetOutline outline(scene_, f);
    const auto points = outline.points();
    const bool proper = continuation_.is_proper(f);
    const Sign turn = scene_.facing[f.index()] == FacetFacing::back ? -1 : 1;
    const CellRange range = grid_.range_of(points);
    if (points.size() == 3 && is_small(range)) return add_small(outline, range, proper, turn, cells);
    boost::container::small_vector<Line, 6> lines;
    for (std::size_t i = 0; i < points.size(); ++i)
      lines.emplace_back(points[i], points[i + 1 == points.size() ? 0 : i + 1], 0);
    grid_.for_each_in_polygon(points, [&](unsigned column, unsigned row) {
      cells.emplace_back(grid_.cell(column, row),
                         !proper || is_over(outline, {lines.data(), lines.size()}, grid_.centre(column, row), turn));
      return true;
    });
  }

 private:
  [[nodiscard]] bool is_over(const FacetOutline& outline, std::span<const Line> lines, const ImagePoint& p,
                             Sign turn) const {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      Sign side = lines[i].certain_side(p, grid_.spread());
      if (side == 0) side = sides_.orientation(outline.ids()[i], outline.ids()[i + 1 == lines.size() ? 0 : i + 1], p);
      if (side * turn < 0) return false;
    }
    return true;
  }

  void add_small(const FacetOutline& outline, const CellRange& range, bool proper, Sign turn,
                 std::vector<FacetCell>& cells) const {
    const TriangleInCells triangle(outline.points(), grid_);
    CellGrid::for_each(range, [&](unsigned column, unsigned row) {
      const ImagePoint centre = grid_.centre(column, row);
      if (range.is_narrow() || !triangle.misses(centre))
        cells.emplace_back(grid_.cell(column, row), !proper || is_over(outline, triangle.lines(), centre, turn));
      return true;
    });
  }

  const ProjectedScene& scene_;
  const CellSides& sides_;
  const Continuation& continuation_;
  const CellGrid& grid_;
};

}  // namespace

FacetCells::FacetCells(const ProjectedScene& scene, const CellSides& sides, const Continuation& continuation,
                       const CellGrid& grid, const std::vector<std::uint8_t>& hidden)
    : begin_(scene.status.size() + 1, 0) {
  const CellsOfFacets cells_of_facets(scene, sides, continuation, grid);
  std::vector<std::vector<FacetCell>> parts(range_count(scene.status.size()));
  parallel_for_ranges(scene.status.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
    std::vector<FacetCell>& part = parts[range];
    for (std::size_t f = begin; f < end; ++f) {
      const std::size_t before = part.size();
      if (scene.status[f] == FacetStatus::in_view && hidden[f] == 0) cells_of_facets.add(FacetId(f), part);
      begin_[f + 1] = static_cast<std::uint32_t>(part.size() - before);
    }
  });
  for (std::size_t f = 1; f < begin_.size(); ++f) begin_[f] += begin_[f - 1];
  cells_.reserve(begin_.back());
  for (const auto& part : parts) cells_.insert(cells_.end(), part.begin(), part.end());
}

}  // namespace sightline::inline sweep
