// Scenes on which it shows whether anything is rounded.
#pragma once

#include <random>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "oracle/scenes/moved_scene.h"

namespace sightline::tests {

using lattice::every_move;
using lattice::moved;
using lattice::Moved;

// Triangles and quadrangles with corners on a grid of 5 x 5 x 5 points, seen from such a point further out: corners on edges,
// edges on edges, faces in one plane, through each other's corners and edges, and seen edge-on are the rule.
[[nodiscard]] Mesh few_points_soup(std::mt19937_64& random);
[[nodiscard]] Camera on_grid_camera(std::mt19937_64& random);

// Triangles before a camera in the origin: needles of an aspect of up to 10^16, planes that are nearly one or nearly edge-on, and
// corners at 2^-400, 1 and 2^400 of the distance, in one face and in several.
[[nodiscard]] Mesh extreme_soup(std::mt19937_64& random);
[[nodiscard]] Camera camera_in_origin();

}  // namespace sightline::tests
