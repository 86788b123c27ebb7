// Ray casting: what a ray through a grid point of the image sees, exactly, without the sweep.
//
// In:  a projected scene for the facets' images and the rays, the mesh and camera for depth. Rays are grid points
// strictly inside the window.
// Out: per ray the facets whose image contains it, nearest first where asked, and the visible polygons that contain it.
// A ray through an edge of any facet's image decides nothing and says so.
// Complexity: O(n log r) for n facets and r rays, plus the pairs of facet and ray whose boxes meet.
#pragma once

#include <vector>

#include "sightline/analyzer.h"

namespace sightline::lattice {

// The rays are sorted by y, and the same for every scene of the same grid.
[[nodiscard]] std::vector<ImagePoint> fixed_rays(int grid_bits, std::size_t count);

struct RayHits {
  bool on_edge = false;
  std::vector<FacetId> facets;  // whose image contains the ray
};
[[nodiscard]] std::vector<RayHits> cast(const ProjectedScene& scene, const std::vector<ImagePoint>& rays);

// Sorts facets along the ray, the nearest first; at equal depth those that look at the eye first, and then the lower face
// index.
void sort_by_depth(std::vector<FacetId>& facets, const PolygonMesh& mesh, const ProjectedScene& scene,
                   const ImagePoint& ray);

// Returns, per ray, which is on no edge, the indices of the visible polygons around it.
[[nodiscard]] std::vector<std::vector<std::size_t>> polygons_around(const View& view,
                                                                    const std::vector<ImagePoint>& rays);

}  // namespace sightline::lattice
