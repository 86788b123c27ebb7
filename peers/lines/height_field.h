// A height field as the floating horizon needs it: polylines from front to back.
//
// In:  a flat scene whose mesh is a single-valued function of two variables.
// Out: its polylines of one constant ground coordinate, the nearest first, and the mesh edges that join each to the
//      next.
// Errors: RefusedScene, where one of these does not hold:
//   - some axis is the height (y is tried first): the vertices are one for each pair of values of the two ground
//     coordinates, and each cell between neighbouring values is one face or two triangles;
//   - both sides count, and no near or far bound is given;
//   - columns of the image are upright planes, since in these the surface in front of a polyline is one connected
//     curve: the camera is not rolled (right is level), and a pinhole looks level, too (forward is); an orthographic
//     camera may look down;
//   - of a pinhole: the whole surface is before the eye's plane, and the eye is on one side of all polylines, so that
//     every ray passes them in one order; of an orthographic camera: it does not look along the polylines.
// Polylines of the other ground coordinate are taken where those of the first are not in order.
// Complexity: O(n log n).
// Source: slides 004, "Single Valued Function of Two Variables", "Horizon Line Algorithm".
#pragma once

#include <array>
#include <vector>

#include "peers/scene/flat_scene.h"

namespace sightline::peers {

struct HeightField {
  std::vector<std::vector<VertexId>> polylines;             // front to back; each along one direction
  std::vector<std::vector<std::array<VertexId, 2>>> joins;  // joins[i]: edges between polylines i and i + 1
};

[[nodiscard]] HeightField height_field(const FlatScene& scene);

}  // namespace sightline::peers
