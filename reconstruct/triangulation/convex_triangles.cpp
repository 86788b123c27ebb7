#include "reconstruct/triangulation/convex_triangles.h"

#include <algorithm>

namespace sightline::inline reconstruct {
namespace {

// This cuts ears off until a triangle is left. An ear may be cut where its two lines are on different sides, and what
// is left is not all on one side.
class EarCutter {
 public:
  explicit EarCutter(std::span<const BorderPoint> border) : points_(border.begin(), border.end()) {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_.push_back(i + 1 == n ? 0 : i + 1);
      previous_.push_back(i == 0 ? n - 1 : i - 1);
      next_side_ = std::max(next_side_, points_[i].side + 1);
    }
    lines_on_side_.resize(next_side_ + n);
    for (const BorderPoint& point : points_) add_line(point.side);
  }

  std::vector<std::array<VertexId, 3>> run() {
    std::vector<std::array<VertexId, 3>> triangles;
    std::size_t at = 0;
    for (std::size_t left = points_.size(); left > 3; --left) {
      while (!is_ear(at)) at = next_[at];
      triangles.push_back(corners(at));
      at = cut(at);
    }
    triangles.push_back(corners(at));
    return triangles;
  }

 private:
  [[nodiscard]] std::array<VertexId, 3> corners(std::size_t i) const {
    return {points_[previous_[i]].vertex, points_[i].vertex, points_[next_[i]].vertex};
  }

  void add_line(std::uint32_t side) { sides_in_use_ += lines_on_side_[side]++ == 0 ? 1 : 0; }
  void remove_line(std::uint32_t side) { sides_in_use_ -= --lines_on_side_[side] == 0 ? 1 : 0; }

  // Without the ear's two lines, the others must lie on two sides at least.
  bool is_ear(std::size_t i) {
    const std::uint32_t before = points_[previous_[i]].side;
    const std::uint32_t after = points_[i].side;
    if (before == after) return false;
    remove_line(before);
    remove_line(after);
    const bool more_than_one_side = sides_in_use_ > 1;
    add_line(before);
    add_line(after);
    return more_than_one_side;
  }

  // Returns where to go on: the point before, whose line is a new side now.
  std::size_t cut(std::size_t i) {
    const std::size_t p = previous_[i];
    remove_line(points_[p].side);
    remove_line(points_[i].side);
    points_[p].side = next_side_++;
    add_line(points_[p].side);
    next_[p] = next_[i];
    previous_[next_[i]] = p;
    return p;
  }

  std::vector<BorderPoint> points_;
  std::vector<std::size_t> next_, previous_;
  std::vector<std::uint32_t> lines_on_side_;
  std::uint32_t next_side_ = 0;
  std::uint32_t sides_in_use_ = 0;
};

}  // namespace

std::vector<std::array<VertexId, 3>> convex_triangles(std::span<const BorderPoint> border) {
  if (border.size() == 3) return {{border[0].vertex, border[1].vertex, border[2].vertex}};
  return EarCutter(border).run();
}

}  // namespace sightline::inline reconstruct
