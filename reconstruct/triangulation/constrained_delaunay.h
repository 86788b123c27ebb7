// Constrained Delaunay triangulation of a planar straight-line graph that is known only by exact signs.
//
// In:  points 0 .. n-1, given by PlanarPoints: pairwise distinct and numbered in sweep order (y descending, then x
//      ascending), so that each point lies outside the convex hull of the earlier ones. Constraints: pairs of distinct
//      points. Two constraints meet in common end points only (or are equal), and no point lies inside a constraint.
// Out: the triangles of the convex hull, counter-clockwise by `orient`, none degenerate; every point is a corner, every
//      constraint an edge, and no edge can be improved by a flip (is_improvable). No triangles where all points are
//      collinear. The same input gives the same triangles in the same order.
// Method, in which no artificial outer point and no point location is needed:
//   1. Each point in turn is joined to the hull edges that it sees; the point before it is a hull vertex that it sees.
//      (The beneath-beyond method: Edelsbrunner, Algorithms in Combinatorial Geometry, 1987, chapter 8.)
//   2. A constraint removes the triangles that it crosses. Each of the two parts left is a polygon whose vertices all
//      see the constraint, so one Sklansky scan triangulates it in linear time with `orient` alone. (Toussaint and
//      Avis, On a convex hull algorithm for polygons and its application to triangulation problems, Pattern Recognition
//      15, 1982; the cavity as in Anglada, An improved incremental algorithm for constructing restricted Delaunay
//      triangulations, Computers & Graphics 21, 1997.)
//   3. After each step of 1 and 2, flips of unconstrained edges. (Lawson, Software for C1 surface interpolation, 1977;
//      Lee and Lin, Generalized Delaunay triangulation for planar graphs, 1986: without an edge to flip, the
//      triangulation is constrained Delaunay.)
// Termination of 3: see flip_improves. Besides, each step stops after n (n - 1) / 2 flips, whatever flip_improves says.
//      Where it is a Delaunay test in coordinates in which the triangulation stays one, no edge flipped away returns
//      within a step, so that many are never reached; only otherwise could an edge be left that a flip improves.
// Complexity: O(n) for 1, O(edges crossed) for a constraint and O(degree of its end point) to find it; flips are about
// O(n) in practice, O(n^1.5) on a square grid of points, O(n^2) at worst.
// Errors: ConstraintConflict where a constraint crosses another one or runs through a point.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "geometry/numbers/errors.h"
#include "geometry/numbers/exact_integer.h"
#include "reconstruct/triangulation/half_edge_triangulation.h"

namespace sightline::inline reconstruct {

// The constraints are no planar straight-line graph.
class ConstraintConflict : public InternalError {
  using InternalError::InternalError;
};

class PlanarPoints {
 public:
  virtual ~PlanarPoints() = default;

  [[nodiscard]] virtual std::size_t size() const = 0;

  // Returns +1 where a, b, c turn counter-clockwise, 0 where they are collinear, else -1; exactly.
  [[nodiscard]] virtual Sign orient(PlanarPointId a, PlanarPointId b, PlanarPointId c) const = 0;

  // Returns whether the diagonal bd of the quadrilateral abcd is better than ac. It is asked of quadrilaterals whose
  // triangles abc and acd are counter-clockwise by `orient`; a flip is made only where abcd is also strictly convex by
  // `orient`.
  //
  // It is true only where the flip lowers some number that the triangulation determines. The exact sign > 0 of the
  // in-circle determinant of a, b, c, d does, in ANY fixed coordinates, which need not agree with `orient`. The number
  // is the sum, over the triangles as they lie in those coordinates, of their signed area times the mean of x^2 + y^2
  // at the three corners. That is the signed volume below the surface lifted to the paraboloid; a flip changes it by
  // the signed volume of the lifted tetrahedron abcd, which is the in-circle determinant over six, whatever the shape
  // of abcd there. (A test that asks in addition for strict convexity in those coordinates is narrower, so it holds the
  // contract too, and keeps the flips from turning triangles over there.)
  //
  // The default never flips: that makes a constrained triangulation, not a Delaunay one.
  [[nodiscard]] virtual bool flip_improves(PlanarPointId /*a*/, PlanarPointId /*b*/, PlanarPointId /*c*/,
                                           PlanarPointId /*d*/) const {
    return false;
  }

 protected:
  PlanarPoints() = default;
  PlanarPoints(const PlanarPoints&) = default;
  PlanarPoints& operator=(const PlanarPoints&) = default;
};

using Constraint = std::array<PlanarPointId, 2>;

[[nodiscard]] HalfEdgeTriangulation constrained_delaunay(const PlanarPoints& points,
                                                         std::span<const Constraint> constraints);

// Returns whether h is neither constrained nor on the hull, its two triangles form a strictly convex quadrilateral, and
// the other diagonal of it is better.
[[nodiscard]] bool is_improvable(const HalfEdgeTriangulation& triangulation, const PlanarPoints& points, HalfEdgeId h);

// Returns what of the above does not hold, one line each, with the ids; nothing for a valid triangulation. That the
// hull is covered once is known from counting: twins match, the boundary is one convex polygon that turns once, every
// point is a corner, and there are 2 n - 2 - h triangles for h boundary edges. It takes O(n log n).
[[nodiscard]] std::vector<std::string> validate(const HalfEdgeTriangulation& triangulation, const PlanarPoints& points,
                                                std::span<const Constraint> constraints);

}  // namespace sightline::inline reconstruct
