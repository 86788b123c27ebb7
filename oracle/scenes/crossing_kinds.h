// Which of the hard cases there are among the common lines of a mesh.
//
// In:  a mesh, cut along its common lines. Out: what of the following there is.
// Source: none; the generator of crossing scenes is held to them.
#pragma once

#include "geometry/mesh/cut_mesh.h"

namespace sightline::lattice {

struct CrossingKinds {
  bool three_in_a_point = false;   // three facets, each through each other, meet in a point
  bool three_on_a_line = false;    // three facets meet along a piece of a common line
  bool end_on_both_edges = false;  // a common line ends on edges of both facets, inside both edges
  bool concave = false;            // a facet of a concave face passes through another face
};

[[nodiscard]] CrossingKinds crossing_kinds(const CutMesh& cut);

}  // namespace sightline::lattice
