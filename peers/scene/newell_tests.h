// Newell's five tests: whether surface P may be painted before surface Q.
//
// In:  two surfaces with their extents. Out: whether the test is true; one that is true suffices. Numbers are the
// slides'. The viewport is nearer than everything, so "on the opposite side of a plane from the viewport" is behind it.
// Tests 3' and 4' of P and Q are tests 3 and 4 of Q and P.
// Holds: 3 or 4' is true where P is not across Q's plane, and 4 or 3' where Q is not across P's. So where all four are
//      false, each of the two has to be split by the other's plane, and can be.
// Tie: of surfaces in one plane the order is that of is_in_front_in_plane.
// Tolerance: planes touch as polygon_split.h says; depths and images touch where they overlap by no more than
//      `touching` (of the depth, or in the window), which may give a pixel as near to an edge to a neighbour.
// Complexity: test 5 O(k^2) for k corners, 3 and 4 O(k), 1 and 2 O(1). Errors: none.
// Source: slides 001, depth-sort algorithm. Test 5 looks for an edge of either image that has the other one outside.
#pragma once

#include "peers/scene/flat_scene.h"
#include "peers/scene/polygon_split.h"

namespace sightline::peers {

struct Surface {
  FlatPolygon polygon;
  Extent extent;
};

// Newell takes "every polygon whose z extent overlaps P's": not those that are nearer throughout.
[[nodiscard]] bool is_nearer_throughout(const Surface& q, const Surface& p);

[[nodiscard]] bool x_extents_apart(const Surface& p, const Surface& q);  // 1
[[nodiscard]] bool y_extents_apart(const Surface& p, const Surface& q);  // 2
[[nodiscard]] bool is_behind(const Surface& p, const Surface& q);        // 3: P behind Q's plane
[[nodiscard]] bool is_before(const Surface& q, const Surface& p);        // 4: Q before P's plane
[[nodiscard]] bool images_apart(const Surface& p, const Surface& q);     // 5

}  // namespace sightline::peers
