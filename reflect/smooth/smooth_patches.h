// One surface in view as the triangles between whose corners its normals are interpolated, and where they are in the image.
//
// In:  a surface in view (a planar face, or a facet), the normals at the corners of its face (vertex_normals.h).
// Out: patches. Each has one or two triangles on the grid, in the window, that cover what is seen of it; and half planes of the
//      window that it shares with its neighbours of the same surface, or that bound it: beyond them the surface is another
//      patch's. A triangle on the grid is a little larger than what it covers, so that rounding loses nothing; its corners are
//      multiples of a power of two, so that it can be halved about as often as its image is spacings wide.
// Complexity: O(k^2) for k corners.
// Source: Koucky 2014, 3.9 (vertex normals); Phong's interpolation.
#pragma once

#include <vector>

#include "geometry/projection/projected_scene.h"
#include "reflect/regions/sheets.h"
#include "reflect/smooth/barycentric_polygon.h"
#include "reflect/smooth/bent_mirror.h"
#include "reflect/world/mirror_world.h"

namespace sightline::inline reflect {

struct SmoothPatch {
  BentTriangle triangle;  // scaled
  std::vector<ImageTriangle> covers;
  std::vector<ImagePolygon> half_planes;
};

[[nodiscard]] std::vector<SmoothPatch> smooth_patches(const MirrorWorld& world, const ProjectedScene& scene,
                                                      FacetId surface);

}  // namespace sightline::inline reflect
