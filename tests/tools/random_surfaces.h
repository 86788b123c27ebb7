// Random surfaces of some hundred facets, snapped to a small grid: large enough for facets that no contour edge comes
// near and for facets behind covers, which the few faces of random_scenes.h hardly ever are.
//
// In:  a seed (the same on every machine). Out: a mesh and the camera that looks down on it.
// Holds: 2 to 4 sheets of squares, one above the other, each square two triangles or one flat face; flat, wavy, or
// with squares missing; they may touch and pass through each other. Sometimes a large triangle is somewhere between.
#pragma once

#include <cstdint>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"

namespace sightline::tests {

struct RandomSurfaces {
  Mesh mesh;  // not cut along common lines
  Camera camera;
};

[[nodiscard]] RandomSurfaces random_surfaces(std::uint64_t seed);

// There are as many sheets of triangles, waved and a little apart, whose vertices lie within a few hundredths of a unit
// of each other in the image: on a coarse grid their edges fall on each other, cross and turn over, and facets
// overlap there that do not overlap.
[[nodiscard]] RandomSurfaces crowded_surfaces(std::uint64_t seed);

}  // namespace sightline::tests
