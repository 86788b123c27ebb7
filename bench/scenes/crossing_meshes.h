// Meshes that touch and pass through themselves, as those of architects and engineers do.
//
// In:  how many triangles, about.
// Out: a mesh; the same in every run, with coordinates of seven decimals.
// Complexity: O(n log n), of build_mesh. Errors: none.
#pragma once

#include <cstddef>

#include "geometry/mesh/mesh.h"

namespace sightline::bench {

// Cubes that touch, each with corners of its own; squares, two triangles each.
[[nodiscard]] Mesh block_of_cubes(std::size_t triangles);

// Bushes on a field: eight leaves each, all of which pass through one another along one stem, and some through those of
// neighbours.
[[nodiscard]] Mesh crossing_leaves(std::size_t triangles);

// Piles of plates, held together by bolts: prisms that pass through all plates of a pile, which have no holes; the plates
// touch, or have a thousandth of play.
[[nodiscard]] Mesh bolted_plates(std::size_t triangles);

// A closed surface of long and thin triangles: as the folded sphere, but of sixteen rows.
[[nodiscard]] Mesh thin_sphere(std::size_t triangles);

// Rooms of furniture: walls, floors, tables and chairs of boards and round legs that stick in each other and in the floor.
[[nodiscard]] Mesh furnished_hall(std::size_t triangles);

}  // namespace sightline::bench
