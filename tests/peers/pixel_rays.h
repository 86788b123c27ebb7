// Rays through the centres of pixels see exactly this: what image-precision peers are held against.
//
// In:  a mesh and its projected scene; a resolution that is a power of two, so that centres are grid points.
// Out: the nearest facet's face per pixel, at equal depth the lower face index (oracle/judging/ray_caster.h).
#pragma once

#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/projected_scene.h"
#include "peers/scene/seen.h"

namespace sightline::tests {

// The rays go row by row from the lowest one up, left to right; they are rounded to the grid where the resolution is no
// power of two.
[[nodiscard]] std::vector<ImagePoint> rays_through_centres(const peers::ItemBuffer& buffer, int grid_bits);

[[nodiscard]] peers::ItemBuffer seen_by_rays(const ProjectedScene& scene, int resolution);

// Returns how many centres an edge of a facet's image passes through exactly.
[[nodiscard]] std::size_t centres_on_edges(const ProjectedScene& scene, int resolution);

[[nodiscard]] int differing_pixels(const peers::ItemBuffer& a, const peers::ItemBuffer& b);

// Returns how many pixels of the two differ although no edge of any facet's image passes within 1e-9 of their centres.
[[nodiscard]] int wrong_pixels(const ProjectedScene& scene, const peers::ItemBuffer& buffer,
                               const peers::ItemBuffer& truth);

}  // namespace sightline::tests
