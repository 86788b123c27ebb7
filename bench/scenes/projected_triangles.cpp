#include "bench/scenes/projected_triangles.h"

#include <cmath>

#include "geometry/projection/camera_forms.h"

namespace sightline::bench {
namespace {

Point3 place_of(const ProjectedScene& scene, const ClippedCorner& corner) {
  const ImagePoint& image = scene.point(corner.point);
  const Camera& camera = scene.camera;
  const double z = camera.projection == Projection::perspective
                       ? -1 / weight_of(scene, corner)
                       : CameraForms<double>(camera).depth_at(position_of(scene, corner));
  return {std::ldexp(static_cast<double>(image.x), -scene.grid_bits),
          std::ldexp(static_cast<double>(image.y), -scene.grid_bits), z};
}

void add_fan(const ProjectedScene& scene, FacetId facet, std::vector<ProjectedTriangle>& triangles) {
  const auto corners = scene.polygon(facet);
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::array<ClippedCorner, 3> fan{corners[0], corners[i - 1], corners[i]};
    if (orientation(scene.point(fan[0].point), scene.point(fan[1].point), scene.point(fan[2].point)) == 0) continue;
    triangles.push_back({place_of(scene, fan[0]), place_of(scene, fan[1]), place_of(scene, fan[2])});
  }
}

}  // namespace

std::vector<ProjectedTriangle> projected_triangles(const ProjectedScene& scene) {
  std::vector<ProjectedTriangle> triangles;
  for (std::size_t f = 0; f < scene.status.size(); ++f) add_fan(scene, FacetId(f), triangles);
  return triangles;
}

}  // namespace sightline::bench
