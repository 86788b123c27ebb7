// Which pixels a polygon covers: those whose centres it contains.
//
// In:  a flat polygon's corners; the item buffer, for where its pixels' centres are.
// Out: whether a place is covered, or the columns of a row that are.
// Holds: a place is covered if it is not left of an edge that goes down at its height, and left of those that go up; an
//      edge has its lower end's height and not its upper end's. So a centre on an edge counts as if it were shifted to
//      the right, and less far up, by less than any number: of polygons that share an edge one, and only one, has the
//      centres on it, and corners need no rule of their own. The orientations are exact (predicates.h), for the
//      centres as doubles have them. Only edges at the place's height are asked: the image's grid has bent outlines by
//      less than its spacing, and the line through a very short edge may lead anywhere. Polygons that the grid has
//      flattened or turned over cover nothing.
// Complexity: covers() O(k) for k corners, columns_covered() O(k + log resolution).
// Errors: none.
// Source: slides 001 ("for each pixel in the projection of A") and 003 (point and polygon); both leave open who has the
// centres on an edge.
#pragma once

#include <vector>

#include "peers/scene/flat_scene.h"
#include "peers/scene/seen.h"

namespace sightline::peers {

// A range of columns or rows is begin, ..., end - 1.
struct PixelRange {
  int begin = 0;
  int end = 0;
  [[nodiscard]] bool empty() const { return begin >= end; }
  [[nodiscard]] int size() const { return end - begin; }
};

[[nodiscard]] bool covers(const std::vector<Corner>& corners, const Point2& place);

// Returns the first of the range's pixels that is not before; those that are before come first. It is the range's end
// if all are.
template <class IsBefore>
[[nodiscard]] int first_not_before(PixelRange range, IsBefore is_before) {
  while (!range.empty()) {
    const int middle = range.begin + range.size() / 2;
    if (is_before(middle)) {
      range.begin = middle + 1;
    } else {
      range.end = middle;
    }
  }
  return range.begin;
}

// Returns the first column whose centre is not left of x.
[[nodiscard]] int first_column_from(const ItemBuffer& buffer, double x);

// Returns the rows whose centres are at `bottom` or above it, and below `top`.
[[nodiscard]] PixelRange rows_between(const ItemBuffer& buffer, double bottom, double top);

// Returns the columns of the row that the polygon covers, out of `columns`; the row is one of rows_between its extent.
[[nodiscard]] PixelRange columns_covered(const ItemBuffer& buffer, const std::vector<Corner>& corners, int row,
                                         PixelRange columns);

// Calls visit(column, row) for each pixel that the polygon covers: scan line by scan line.
template <class Visit>
void for_each_covered_pixel(const ItemBuffer& buffer, const std::vector<Corner>& corners, Visit visit) {
  const Extent extent = extent_of(corners);
  const PixelRange within{first_column_from(buffer, extent.least.x), first_column_from(buffer, extent.most.x)};
  const PixelRange rows = rows_between(buffer, extent.least.y, extent.most.y);
  for (int row = rows.begin; row < rows.end; ++row) {
    const PixelRange columns = columns_covered(buffer, corners, row, within);
    for (int column = columns.begin; column < columns.end; ++column) visit(column, row);
  }
}

}  // namespace sightline::peers
