// Scenes on which it shows whether anything is rounded.
#pragma once

#include <array>
#include <random>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "oracle/scenes/random_scenes.h"

namespace sightline::tests {

// A small turn leaves nothing on the lattice; a last bit leaves everything nearly on it; and parts of a spacing of the image's
// grid leave everything as far off it as rounding moves it.
enum class Moved { not_at_all, turned, by_last_bits, by_parts_of_spacings };
inline constexpr std::array every_move{Moved::not_at_all, Moved::turned, Moved::by_last_bits,
                                       Moved::by_parts_of_spacings};

[[nodiscard]] Mesh moved(const lattice::RandomScene& scene, Moved how);

// Triangles and quadrangles with corners on a grid of 5 x 5 x 5 points, seen from such a point further out: corners on edges,
// edges on edges, faces in one plane, through each other's corners and edges, and seen edge-on are the rule.
[[nodiscard]] Mesh few_points_soup(std::mt19937_64& random);
[[nodiscard]] Camera on_grid_camera(std::mt19937_64& random);

}  // namespace sightline::tests
