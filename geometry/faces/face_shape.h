// Exact questions about one polygon in space: which of its corners bound nothing, is it planar, is it convex.
//
// In:  corners as vertex indices in order around the polygon, and the positions of all vertices (finite, any size).
// Out: exact answers; positions are compared by value (-0.0 equals 0.0), never by index.
// Complexity: O(k) exact predicates for k corners. Nothing is thrown.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/numbers/ids.h"
#include "geometry/numbers/predicates.h"
#include "geometry/numbers/vector3.h"

namespace sightline::inline geometry {

// The polygon is closed, and corner indices are cyclic: corner size() is corner 0 again.
struct PolygonView {
  std::span<const VertexId> corners;
  std::span<const Point3> vertices;

  [[nodiscard]] std::size_t size() const { return corners.size(); }
  [[nodiscard]] const Point3& operator[](std::size_t i) const {
    return vertices[corners[i < size() ? i : i - size()].index()];
  }
};

// Compares x first, then y, then z.
[[nodiscard]] bool lexicographically_less(const Point3& a, const Point3& b);

// Returns whether corner b of a boundary that runs from a to b to c bounds nothing: it equals a neighbour, or the
// boundary turns back there on its own line (the tip of a spike).
[[nodiscard]] bool bounds_nothing(const Point3& a, const Point3& b, const Point3& c);

// Removes consecutive equal corners and tips of spikes until none is left. What remains bounds the same area, and each
// corner differs from the next; fewer than three corners remain (possibly none) if the polygon bounds no area at all.
// A corner inside a straight run is no spike and stays.
void remove_spikes(std::vector<VertexId>& corners, std::span<const Point3> vertices);

// Returns three corners (indices into the polygon) that are not on one line; nullopt if all corners are on one line.
[[nodiscard]] std::optional<std::array<std::size_t, 3>> corners_off_line(const PolygonView& polygon);

// Returns whether all corners lie in one plane.
[[nodiscard]] bool is_planar(const PolygonView& polygon);

// Returns whether a planar polygon without spikes is convex: it turns to one side only and goes round once. Corners
// inside a straight run are allowed; an area of zero is not.
[[nodiscard]] bool is_convex(const PolygonView& polygon);

}  // namespace sightline::inline geometry
