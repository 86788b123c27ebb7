// Convex polygons of the image: the overlap of two, and what is left of one outside another.
//
// In:  strictly convex rings, counter-clockwise, in the window's coordinates (convex_image makes one of a polygon).
// Out: rings of the same kind. Each cut goes along the line of one edge.
// Holds: the overlap and the remains of a ring do not overlap each other, and together they are the ring, up to the
//      rounding of the cuts' points and up to parts that are below resolution.
// Below resolution is a ring with 2 * area / perimeter under 2^-40, the spacing of the image's default grid. Points of
// cuts are computed in double and miss their line by some 2^-52, which leaves parts that thin along lines that are
// shared by several polygons; they are no parts of the scene.
// Complexity: O(k m) for rings of k and m corners.
// Errors: none.
// Source: Sutherland and Hodgman's clipping (Fang 5.2.2), against the edges of a polygon instead of a window's.
#pragma once

#include <vector>

#include "geometry/numbers/predicates.h"
#include "peers/scene/flat_scene.h"

namespace sightline::peers {

using ConvexRing = std::vector<Point2>;

// These are the smallest and largest x and y: the slides' minmax of a projection.
struct MinMax {
  Point2 least;
  Point2 most;
};
[[nodiscard]] MinMax minmax_of(const ConvexRing& ring);

// Returns whether the extents have a point in common.
[[nodiscard]] bool extents_overlap(const MinMax& a, const MinMax& b);
[[nodiscard]] bool contains(const MinMax& extent, const Point2& p);

// Returns the area of a ring, convex or not: it is positive where the ring runs counter-clockwise, and 0 for fewer than
// three corners. It is computed relative to the first corner.
[[nodiscard]] inline double signed_area(const std::vector<Point2>& ring) {
  double twice = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Point2& p = ring[i - 1];
    const Point2& q = ring[i];
    twice += (p.x - ring[0].x) * (q.y - ring[0].y) - (p.y - ring[0].y) * (q.x - ring[0].x);
  }
  return twice / 2;
}

[[nodiscard]] bool is_below_resolution(const ConvexRing& ring);

// Returns the convex hull of a polygon's corners, exactly. Rounding to the grid may have dented the polygon, by less
// than a grid's spacing; and a corner on a straight edge is left out. It is empty where all corners are on one line.
[[nodiscard]] ConvexRing convex_image(const FlatPolygon& polygon);

// Returns what both have in common; it is empty where that is below resolution.
[[nodiscard]] ConvexRing overlap(const ConvexRing& a, const ConvexRing& b);

// Returns the parts of the ring outside the other one: the ring itself where nothing is in common.
[[nodiscard]] std::vector<ConvexRing> remains(const ConvexRing& ring, const ConvexRing& taken_away);

}  // namespace sightline::peers
