// One facet cut where others pass through it, so that no piece is passed through.
//
// In:  a facet and its cutters: the plane of each facet that crosses it, and the chord in which the two meet.
// Out: the pieces: convex, in the facet's orientation, together the facet; no chord has more than a border of a piece
//      in common with it. Exact.
// Method: a binary space partition. A piece that a chord enters is cut all along the cutter's plane, beyond the chord's
// ends too: so that a piece is convex and has one order in depth with the cutter. The pieces are those of the order in
// which the cutters are given.
// Complexity: O(log m) pieces are looked at per chord and piece that it enters, expected for m cutters in random order.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/exact_position.h"

namespace sightline::inline geometry {

// A chord is a segment of a line; its ends are in lexicographic order.
struct Chord {
  ExactPosition low;
  ExactPosition high;
};

struct Cutter {
  const ExactPlane* plane;
  const Chord* chord;
};

struct CutCorner {
  ExactPosition position;
  VertexId vertex;        // of the input; invalid: made by cutting
  MeshEdgeId edge_after;  // that the line to the next corner is on; invalid: on the plane of a cutter
};
using CutPolygon = std::vector<CutCorner>;

[[nodiscard]] CutPolygon facet_polygon(const Mesh& mesh, FacetId facet);
[[nodiscard]] CutPolygon facet_polygon(const CutMesh& mesh, FacetId facet);

// Returns the part of a convex polygon in front of a plane; it is empty where nothing is strictly in front.
[[nodiscard]] CutPolygon part_in_front(const CutPolygon& polygon, const ExactPlane& plane);

// Returns where a convex polygon meets a plane. Precondition: it has corners strictly on both sides.
[[nodiscard]] Chord meet(const CutPolygon& polygon, const ExactPlane& plane);

// Returns what two chords of one line have in common. Precondition: that is more than a point.
[[nodiscard]] Chord common_part(const Chord& a, const Chord& b);

// Returns whether a chord in a plane enters the inside of a convex polygon.
[[nodiscard]] bool passes_through(const ExactPlane& plane, const Chord& chord, const CutPolygon& polygon);

[[nodiscard]] std::vector<CutPolygon> cut_facet(CutPolygon facet, std::span<const Cutter> cutters);

}  // namespace sightline::inline geometry
