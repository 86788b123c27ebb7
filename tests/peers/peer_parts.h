// Peers that give visible parts, held against the exact sweep.
//
// In:  a mesh that is cut along its common lines, a camera. Out: what the peer and the sweep say of each face.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "peers/scene/peer.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests {

// Each face has its area, in window units squared.
using FaceAreas = std::vector<double>;

struct PartsCase {
  peers::VisibleParts parts;
  FaceAreas seen;   // as the peer says
  FaceAreas exact;  // as the sweep says
  std::vector<peers::Count> counts;
};

[[nodiscard]] PartsCase parts_case(const peers::Peer& peer, const AnyMesh& mesh, const Camera& camera,
                                   Sides sides = Sides::both);

// Returns the largest difference between what is seen of a face and what the sweep says.
[[nodiscard]] double largest_error(const PartsCase& parts);

// Returns how much the parts of one face overlap, all faces together. Parts are convex.
[[nodiscard]] double overlap_within_faces(const peers::VisibleParts& parts);

[[nodiscard]] std::uint64_t number_of(const PartsCase& parts, const std::string& what);

// The camera looks down the z axis; the window is [-1, 1]^2.
[[nodiscard]] Camera straight_down();

}  // namespace sightline::tests
