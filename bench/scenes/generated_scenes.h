// Scenes of any size for measurements, the same in every run.
//
// In:  how many triangles, about.
// Out: a mesh within [-1.7, 1.7]^3, and the cameras that look at it.
// Holds: coordinates have seven decimals, so that an OBJ file of them is a typical one, and says the same; no two
//      triangles meet, but in shared vertices and edges.
// Complexity: O(n log n), of build_mesh. Errors: none.
#pragma once

#include <cstddef>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"

namespace sightline::bench {

// This is a closed surface with folds that hide parts of it: a sphere whose radius waves.
[[nodiscard]] Mesh folded_sphere(std::size_t triangles);

// This is a height field of waves in waves.
[[nodiscard]] Mesh terrain(std::size_t triangles);

// A soup has unconnected triangles at random places of a box, turned at random, in random order. The shrinking ones
// have edges of about 11 / sqrt(n), so that five are expected over a point whatever n is; the others edges of about
// 0.35, so that n / 190 are. The box is made of layers and pressed together along the view, which flattens what is in
// it.
[[nodiscard]] Mesh shrinking_soup(std::size_t triangles);
[[nodiscard]] Mesh deep_soup(std::size_t triangles);

// Gridded squares of one size lie one behind the other, in waves that are flatter than their distance. Seen in
// perspective the front one is the largest and hides all others: wholly, or, with `leaves`, where it has a hole,
// without half its cells.
enum class FrontSheet { whole, leaves };
[[nodiscard]] Mesh sheets(std::size_t triangles, std::size_t count, FrontSheet front);

// There is a view of the whole surface, one over the terrain at a grazing angle, one from above that sees all of it,
// and one of soups and sheets that is as wide as the front of their box.
[[nodiscard]] Camera overview();
[[nodiscard]] Camera grazing_view();
[[nodiscard]] Camera view_from_above();
[[nodiscard]] Camera view_into_box();

}  // namespace sightline::bench
