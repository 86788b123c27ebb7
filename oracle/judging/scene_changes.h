// These changes of a scene change nothing but order; what must stay is here, too.
#pragma once

#include "oracle/judging/judge.h"
#include "oracle/lattice/lattice.h"

namespace sightline::lattice {

// order[i] is the old index of the new face i.
struct Shuffled {
  Mesh mesh;
  std::vector<std::size_t> order;
};
[[nodiscard]] Shuffled with_faces_shuffled(const PolygonMesh& mesh, Dice& dice);

[[nodiscard]] Mesh with_corners_rotated(const PolygonMesh& mesh, Dice& dice);

// x becomes -x, and corners run the other way round. Seen by the mirrored camera the image is mirrored: left is right.
[[nodiscard]] Mesh mirrored(const PolygonMesh& mesh);
[[nodiscard]] Camera mirrored(const Camera& camera);

// Returns the camera turned by a quarter about its view direction: what was to the right is up.
[[nodiscard]] Camera rolled(const Camera& camera);

// The outcome is the same whatever the order.
struct Outcome {
  std::vector<Rational> areas;  // visible, per face
  std::size_t segments = 0;
  std::size_t polygons = 0;
  std::size_t rings = 0;
};
[[nodiscard]] Outcome outcome(const View& view);

[[nodiscard]] Complaints differences(const Outcome& before, const Outcome& after);

// Compares bit for bit.
[[nodiscard]] bool identical(const View& a, const View& b);

}  // namespace sightline::lattice
