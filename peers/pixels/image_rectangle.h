// Rectangles of whole pixels, and how polygons lie to them.
//
// In:  a rectangle; a polygon. Out: the rectangle's four parts; whether the polygon is disjoint from it, encloses it,
//      or intersects it, which includes lying in it.
// Holds: touching is not overlapping. A polygon that encloses a rectangle covers all its pixels' centres, one that is
//      disjoint from it none of them. (The rectangle's borders are rounded in double where the resolution is no power
//      of two; the centres lie half a pixel inside.)
// Complexity: O(k) for k corners. Errors: none.
// Source: slides 001, "Overlap and Containment" (1) to (3): bounding box, edge intersection, containment.
#pragma once

#include <array>
#include <cstdint>

#include "peers/errors/pixel_cover.h"

namespace sightline::peers {

struct Rectangle {
  PixelRange columns;
  PixelRange rows;

  [[nodiscard]] bool empty() const { return columns.empty() || rows.empty(); }
  [[nodiscard]] bool is_pixel() const { return columns.size() == 1 && rows.size() == 1; }
};

// Returns the left upper, right upper, left lower and right lower part; they are empty where a side has one pixel.
[[nodiscard]] std::array<Rectangle, 4> parts_of(const Rectangle& r);

// These are the corners in the window, counter-clockwise from the left lower one.
using Vertices = std::array<Point2, 4>;
[[nodiscard]] Vertices vertices_of(const Rectangle& r, int resolution);

enum class Overlap : std::uint8_t { disjoint, intersecting, enclosing };
[[nodiscard]] Overlap overlap_of(const std::vector<Corner>& corners, const Extent& extent, const Vertices& rectangle);

}  // namespace sightline::peers
