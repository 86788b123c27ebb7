// A triangulation of points in the plane is given as half-edges, with its regions between constraints.
//
// Triangle t owns the half-edges 3t, 3t + 1, 3t + 2. Half-edge h runs from origin[h] to the origin of the next
// half-edge of its triangle and has the triangle on its left, so the corners of every triangle are counter-clockwise.
// Holds (validate in constrained_delaunay.h checks it): twin is symmetric and joins equal end points in opposite
// direction; a half-edge without a valid twin is on the boundary of the convex hull; twins are constrained together.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/numbers/ids.h"

namespace sightline::inline reconstruct {

using PlanarPointId = Id<struct PlanarPointTag>;  // a point of one triangulation, in its sweep order
using TriangleId = Id<struct TriangleTag>;
using HalfEdgeId = Id<struct HalfEdgeTag>;
using RegionId = Id<struct RegionTag>;

[[nodiscard]] constexpr HalfEdgeId half_edge(TriangleId t, std::size_t side) {
  return HalfEdgeId(3 * t.index() + side);
}
[[nodiscard]] constexpr TriangleId triangle_of(HalfEdgeId h) { return TriangleId(h.index() / 3); }
[[nodiscard]] constexpr HalfEdgeId next(HalfEdgeId h) {
  return HalfEdgeId(h.index() + (h.index() % 3 == 2 ? 0 : 3) - 2);
}
[[nodiscard]] constexpr HalfEdgeId previous(HalfEdgeId h) { return next(next(h)); }

struct HalfEdgeTriangulation {
  // All three have one entry per half-edge.
  std::vector<PlanarPointId> origin;
  std::vector<HalfEdgeId> twin;
  std::vector<std::uint8_t> constrained;  // 1 on a constraint, else 0

  [[nodiscard]] std::size_t triangle_count() const { return origin.size() / 3; }
  [[nodiscard]] PlanarPointId from(HalfEdgeId h) const { return origin[h.index()]; }
  [[nodiscard]] PlanarPointId to(HalfEdgeId h) const { return origin[next(h).index()]; }
  // Returns the corner of h's triangle that is not on h.
  [[nodiscard]] PlanarPointId apex(HalfEdgeId h) const { return origin[previous(h).index()]; }
  [[nodiscard]] HalfEdgeId twin_of(HalfEdgeId h) const { return twin[h.index()]; }
  [[nodiscard]] bool is_constrained(HalfEdgeId h) const { return constrained[h.index()] != 0; }

  [[nodiscard]] std::array<PlanarPointId, 3> corners(TriangleId t) const {
    return {from(half_edge(t, 0)), from(half_edge(t, 1)), from(half_edge(t, 2))};
  }
  // Returns the triangle across the side from corner `side` to the following one; invalid outside the hull.
  [[nodiscard]] TriangleId neighbour(TriangleId t, std::size_t side) const {
    const HalfEdgeId across = twin_of(half_edge(t, side));
    return across.valid() ? triangle_of(across) : TriangleId{};
  }

  friend bool operator==(const HalfEdgeTriangulation&, const HalfEdgeTriangulation&) = default;
};

// The constraints cut the triangulation into these regions.
struct Regions {
  std::vector<RegionId> of_triangle;  // numbered from 0 by their first triangle
  std::size_t count = 0;
};

// Two triangles share a region where a path from one to the other crosses no constraint. This takes O(triangles).
[[nodiscard]] Regions flood_regions(const HalfEdgeTriangulation& triangulation);

}  // namespace sightline::inline reconstruct
