// Changing a half-edge triangulation locally, without predicates: the operations that constrained_delaunay is made of.
//
// Holds between operations, besides what holds for a HalfEdgeTriangulation: outgoing[p] is a half-edge from p, and the
// one on the hull if p is on the hull; so turning counter-clockwise from outgoing[p] passes all triangles at p.
// Complexity: every operation is constant, but for find_outgoing (the degree of p) and move_last (the slots).
#pragma once

#include <utility>

#include "reconstruct/triangulation/half_edge_triangulation.h"

namespace sightline::inline reconstruct {

struct EditableTriangulation : HalfEdgeTriangulation {
  std::vector<HalfEdgeId> outgoing;  // per point; invalid before its first triangle

  explicit EditableTriangulation(std::size_t points) : outgoing(points) {}

  // Leaves linking and outgoing to the caller.
  TriangleId add_triangle(PlanarPointId a, PlanarPointId b, PlanarPointId c);

  // Makes g and h twins; an invalid h puts g on the boundary.
  void link(HalfEdgeId g, HalfEdgeId h);

  // `by`, which has the same ends, takes the place of `old`: its twin, its constraint, and its place in outgoing. `old`
  // then belongs to nothing.
  void replace(HalfEdgeId old, HalfEdgeId by);

  // The quadrilateral abcd around h = ac gets the diagonal bd. h, next(h), its twin g and next(g) are its sides then.
  void flip(HalfEdgeId h);

  // Moves the last triangles to `slots`, whose own triangles belong to nothing, so that the numbering stays dense.
  void move_last(const std::vector<TriangleId>& slots);

  void constrain(HalfEdgeId h);

  // Returns the first half-edge from p, in counter-clockwise order from outgoing[p], that is wanted; invalid if none
  // is.
  template <class Wanted>
  [[nodiscard]] HalfEdgeId find_outgoing(PlanarPointId p, Wanted wanted) const;

  // Returns the half-edge from p to q; from q to p where that is on the hull; invalid where pq is no edge.
  [[nodiscard]] HalfEdgeId edge_between(PlanarPointId p, PlanarPointId q) const;
};

template <class Wanted>
HalfEdgeId EditableTriangulation::find_outgoing(PlanarPointId p, Wanted wanted) const {
  const HalfEdgeId first = outgoing[p.index()];
  HalfEdgeId h = first;
  do {
    if (wanted(h)) return h;
    h = twin_of(previous(h));
  } while (h.valid() && h != first);
  return HalfEdgeId{};
}

}  // namespace sightline::inline reconstruct
