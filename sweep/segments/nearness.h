// How near the plane of a surface is to the eye, as a linear form of the place in the image.
//
// In:  a scene; surfaces (facet_plane.h) that are not edge-on. Their planes are those that they have in the order of depth.
// Out: at the place (x, y) of the image (a x + b y + c) / k, k > 0: 1 / W in perspective, minus the depth otherwise; with bounds,
//      and exactly.
// Method: in the camera's coordinates P = (X, Y, depth) the plane through P0, with the normal n = (P1 - P0) x (P2 - P0), is
//      n . (P - P0) = 0. In perspective P is W (x, y, 1), so 1 / W = n . (x, y, 1) / n . P0; otherwise minus the depth is
//      (n.X x + n.Y y - n . P0) / n.depth.
// Complexity: O(1), in integers of any size where exact.
#pragma once

#include <optional>
#include <unordered_map>

#include "geometry/numbers/bounded.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

template <class Number>
struct Nearness {
  Number a, b, c, k;
};

// Returns nothing where the sign of k is open.
[[nodiscard]] std::optional<Nearness<Bounded>> bounded_nearness(const ProjectedScene& scene, FacetId surface);

// What was asked for is kept. Not for several threads at once.
class ExactNearness {
 public:
  explicit ExactNearness(const ProjectedScene& scene) : scene_(scene), corners_(scene.camera) {}  // outlives it

  [[nodiscard]] const Nearness<BigInteger>& of(FacetId surface);

 private:
  const ProjectedScene& scene_;
  ExactCorners corners_;
  std::unordered_map<std::uint32_t, Nearness<BigInteger>> known_;  // per surface; only looked up
};

}  // namespace sightline::inline sweep
