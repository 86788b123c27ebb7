// Which sides of the faces count.
//
// `front`: back-facing faces are neither seen nor in the way (Koucky 3.5, Fang). `both`: every face is in the way.
// `automatic` culls only where that provably changes nothing: the mesh is closed and consistently oriented (every
// edge lies on exactly two facets, which run through it in opposite directions), no two facets meet except in shared
// vertices and edges, every component encloses a positive volume, the camera has no near plane that could cut one
// open, and the eye is outside all of them (for an orthographic camera: the eye is at infinity, hence outside). All
// tested exactly. Then a ray from the eye enters through a front side first.
// Complexity: O(n log n) plus the pairs of facets whose boxes overlap.
#pragma once

#include <string>

#include "geometry/cutting/interpenetration.h"
#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/export.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline geometry {

enum class SidesPolicy { automatic, front, both };

// The policy that says these sides, whatever the mesh.
[[nodiscard]] constexpr SidesPolicy policy_of(Sides sides) {
  return sides == Sides::front ? SidesPolicy::front : SidesPolicy::both;
}

struct SidesDecision {
  Sides sides = Sides::both;
  std::string reason;  // for the report, e.g. "both sides: edge 12-17 has one facet"
};

// Returns whether every edge lies on two facets that run through it in opposite directions. Where that is not so, both sides
// count, whatever meets what.
[[nodiscard]] SIGHTLINE_EXPORT bool is_closed(const CutMesh& mesh);

// `contacts` says how the mesh met itself before it was cut along common lines, if it was (interpenetration.h).
[[nodiscard]] SIGHTLINE_EXPORT SidesDecision decide_sides(const CutMesh& mesh, const MeshContacts& contacts,
                                                          const Camera& camera, SidesPolicy policy);

}  // namespace sightline::inline geometry
