// The depth of a facet's plane along a ray of the camera is exact, for cameras and coordinates of any finite doubles.
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::lattice {

// The nearness is numerator / denominator: 1 / W of a pinhole, minus the depth of an orthographic camera. denominator >
// 0.
struct RayDepth {
  BigInteger numerator;
  BigInteger denominator;
};

// Precondition: the facet is not edge-on. The ray goes through a grid point of the image.
[[nodiscard]] RayDepth depth_along(const PolygonMesh& mesh, const ProjectedScene& scene, FacetId facet,
                                   const ImagePoint& ray);

// Returns +1 where a is nearer than b, 0 at equal depth.
[[nodiscard]] Sign nearer(const RayDepth& a, const RayDepth& b);

}  // namespace sightline::lattice
