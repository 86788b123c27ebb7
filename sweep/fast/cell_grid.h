// The image divided into square cells, a power of two of them along each side of the window.
//
// In:  points in the window, in grid units.
// Out: the cells that points, edges and convex polygons touch; a few more are named, never one too few.
//      Points may be off by a spread, in each coordinate: then the cells are named that they may touch.
// Holds: cells are closed: what lies on the line between two cells touches both.
// Complexity: O(1) per cell that is named.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <span>

#include "geometry/numbers/image_point.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

using CellIndex = std::uint32_t;

// Returns the finest level that pays: a cell takes time though it is empty, so there are not many more of them than facets,
// however small these are in the image.
[[nodiscard]] int highest_level_for(std::size_t facets);

// The range has the cells in a rectangle, its ends included.
struct CellRange {
  std::uint16_t left = 0;
  std::uint16_t bottom = 0;
  std::uint16_t right = 0;
  std::uint16_t top = 0;

  [[nodiscard]] bool is_narrow() const { return left == right || bottom == top; }
};

// Without rounding the grid has each point within a spacing of where it is (exact_place.h).
[[nodiscard]] inline int spread_of(const ProjectedScene& scene) { return scene.is_unrounded() ? 1 : 0; }

// A facet's polygon on the grid is given to the cells as plain points.
class FacetOutline {
 public:
  FacetOutline(const ProjectedScene& scene, FacetId f) {
    for (const ClippedCorner& corner : scene.polygon(f)) {
      ids_.push_back(corner.point);
      points_.push_back(scene.point(corner.point));
    }
  }
  [[nodiscard]] std::span<const PointId> ids() const { return {ids_.data(), ids_.size()}; }
  [[nodiscard]] std::span<const ImagePoint> points() const { return {points_.data(), points_.size()}; }

 private:
  boost::container::small_vector<PointId, 6> ids_;
  boost::container::small_vector<ImagePoint, 6> points_;
};

class CellGrid {
 public:
  // The grid has 2^level cells along each side. What lies where on the image's grid is known up to `spread` spacings.
  CellGrid(int grid_bits, int level, int spread = 0);

  [[nodiscard]] unsigned side() const { return 1U << level_; }
  [[nodiscard]] std::size_t cell_count() const { return std::size_t{1} << (2 * level_); }
  [[nodiscard]] CellIndex cell(unsigned column, unsigned row) const { return (row << level_) + column; }
  [[nodiscard]] ImagePoint centre(unsigned column, unsigned row) const;
  [[nodiscard]] std::int64_t cell_size() const { return std::int64_t{1} << shift_; }
  [[nodiscard]] int spread() const { return spread_; }

  // Returns the cells that the points' bounding box touches. Precondition: there is a point.
  [[nodiscard]] CellRange range_of(std::span<const ImagePoint> points) const;

  // Calls visit(column, row) for the cells that the segment from a to b touches.
  template <class Visit>
  void for_each_on_segment(const ImagePoint& a, const ImagePoint& b, Visit visit) const {
    for_each_in_polygon(std::initializer_list<ImagePoint>{a, b}, visit);
  }

  // Calls visit(column, row) for the cells that a convex polygon touches, until it returns false.
  template <class Visit>
  bool for_each_in_polygon(std::span<const ImagePoint> polygon, Visit visit) const {
    const CellRange range = range_of(polygon);
    if (range.is_narrow()) return for_each(range, visit);
    const auto rows = columns_by_row(polygon, range);
    for (unsigned row = range.bottom; row <= range.top; ++row) {
      const Columns& columns = rows[row - range.bottom];
      for (unsigned column = columns.first; column <= columns.last; ++column) {
        if (!visit(column, row)) return false;
      }
    }
    return true;
  }
  template <class Visit>
  bool for_each_in_polygon(std::initializer_list<ImagePoint> polygon, Visit visit) const {
    return for_each_in_polygon(std::span(polygon.begin(), polygon.size()), visit);
  }

  template <class Visit>
  static bool for_each(const CellRange& range, Visit visit) {
    for (unsigned row = range.bottom; row <= range.top; ++row) {
      for (unsigned column = range.left; column <= range.right; ++column) {
        if (!visit(column, row)) return false;
      }
    }
    return true;
  }

 private:
  struct Columns {
    unsigned first = 1;  // none
    unsigned last = 0;
  };
  using Rows = boost::container::small_vector<Columns, 16>;

  [[nodiscard]] Rows columns_by_row(std::span<const ImagePoint> polygon, const CellRange& range) const;
  [[nodiscard]] unsigned first_touched(std::int64_t coordinate) const;
  [[nodiscard]] unsigned last_touched(std::int64_t coordinate) const;

  int level_;
  int spread_;
  int shift_;  // a cell is 2^shift grid units wide
  std::int64_t half_window_;
};

}  // namespace sightline::inline sweep
