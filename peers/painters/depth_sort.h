// Depth sort, the painter's algorithm: the polygons in an order in which they can be painted over one another.
//
// In:  the flat scene. Out: its polygons back to front, some of them split; and the item buffer painted that way.
// List: the surfaces sorted by their farthest depth. P is the farthest one. It is tested against each surface Q whose
// depths overlap its own; where one of Newell's five tests (newell_tests.h) is true of every Q, P is painted. Where all
// fail for some Q, but 3' or 4' is true, Q must be painted before P: the two are reversed, which here means that Q goes
// to the end of the list, beyond P, and the algorithm goes on with Q as P. The flag that this was done is Q's place:
// `moved` are those that went to the end. Where that does not help, or was done before, surfaces are split.
// Ends: a surface moves at most once before it is painted or something is split. A split leaves each part on one side
// of a plane, where its own parts stay (rounding moves a cut's corners by some 2^-13 of the tolerance); planes are no
// more than polygons, so splits end, too.
// Departures: the slides split P and Q, both. One suffices, P where that can be: its farther part, Q, its nearer part
// is an order already. And neither need be across the other's plane: in a cycle of more than two, of which Q is the
// first to be painted and P the last, any one that is across another one's plane is split. After a split what had moved
// is sorted in again.
// Precision: order at object precision, in doubles (tolerances and ties: newell_tests.h); painting at image precision.
// A cycle in which nothing is across a plane by more than the tolerance is painted as it comes, and counted.
// Cost: O(n log n + pairs whose depths overlap), O(n^2) pairs at worst, each again after a move; splits up to O(n^3).
// Errors: none. Source: slides 001, depth-sort algorithm.
#pragma once

#include <cstdint>
#include <vector>

#include "peers/painters/painting.h"
#include "peers/scene/peer.h"

namespace sightline::peers {

// With `never` one sees what the split is for: P is painted where reversing does not help.
enum class Splitting : std::uint8_t { where_needed, never };

struct DepthSorted {
  BackToFront polygons;
  std::uint64_t moves = 0;
  std::uint64_t splits = 0;
  std::uint64_t unresolved = 0;  // cycles that no plane cuts
  std::vector<Count> counts;
};

[[nodiscard]] DepthSorted sort_by_depth(const FlatScene& scene, Splitting splitting = Splitting::where_needed);

[[nodiscard]] Peer depth_sort();

}  // namespace sightline::peers
