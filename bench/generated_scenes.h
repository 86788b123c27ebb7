// Scenes of any size for measurements, the same in every run.
#pragma once

#include <cstddef>

#include "geometry/camera.h"
#include "geometry/mesh.h"

namespace sightline::bench {

// A closed surface with folds that hide parts of it: a sphere whose radius waves. About `triangles` triangles.
[[nodiscard]] Mesh folded_sphere(std::size_t triangles);

// A height field of waves in waves. About `triangles` triangles.
[[nodiscard]] Mesh terrain(std::size_t triangles);

// Flat square grids, one behind the other. About `triangles` triangles in all.
[[nodiscard]] Mesh sheets(std::size_t triangles, std::size_t count);

// A view of the whole surface, one over the terrain at a grazing angle, one from above that sees all of it, and one of
// the sheets, where the first hides all others.
[[nodiscard]] Camera overview();
[[nodiscard]] Camera grazing_view();
[[nodiscard]] Camera view_from_above();
[[nodiscard]] Camera view_from_the_front();

}  // namespace sightline::bench
