// These tell whether planar polygons of lattice points are simple, and convex.
#pragma once

#include <vector>

#include "oracle/lattice/camera_space.h"
#include "oracle/lattice/lattice.h"

namespace sightline::lattice {

// Returns the polygon along a coordinate axis that its plane is not parallel to; empty where its corners are collinear.
[[nodiscard]] Ring flattened(const std::vector<LatticePoint>& corners);

// In a simple ring no two edges meet except neighbours in their common corner. Straight corners are allowed.
[[nodiscard]] bool is_simple(const Ring& ring);

// In a convex ring no corner turns against the others.
[[nodiscard]] bool is_convex(const Ring& ring);

}  // namespace sightline::lattice
