// The generator of scenes asks how two faces lie to each other: the answer is exact, by decomposition of their two
// images.
#pragma once

#include <optional>
#include <vector>

#include "oracle/lattice/camera_space.h"

namespace sightline::lattice {

// This is a planar polygon before the camera. Where all corners are in front of the eye, `image` is all of it, else the
// part in the view volume.
struct PlacedFace {
  std::vector<CameraPoint> corners;
  Plane plane;
  Ring image;
  bool whole = false;
};

enum class Relation {
  separate,  // their images do not overlap, or one is edge-on
  ordered,   // one is nearer wherever they overlap, though they may touch at the overlap's border
  coplanar,  // they overlap in one plane
  crossing,  // each is nearer somewhere in the overlap
};

[[nodiscard]] Relation relation(const PlacedFace& a, const PlacedFace& b);

// Returns whether each of the two has corners strictly on both sides of the other's plane: without this they cannot
// cross.
[[nodiscard]] bool straddle(const PlacedFace& a, const PlacedFace& b);

}  // namespace sightline::lattice
