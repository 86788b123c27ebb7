// The projection of single vertices: outside of which bounds, and where in the image.
//
// In:  a vertex and a camera.
// Out: its outcode (exact), and for a vertex in the view volume its grid point (the nearest one to the exact
//      projection) and W. A filter in double with a running error bound decides nearly all; clipping.h is the exact
//      tier behind it.
// Source: Fang 1993, 5.2.2-5.2.3.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/image_point.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/exact_place.h"

namespace sightline::inline geometry {

struct ProjectedVertex {
  std::uint8_t strictly_outside = 0;  // bit per bound of the view volume, in the order of window edge coordinates
  std::uint8_t on_or_outside = 0;
  ImagePoint image;  // where strictly_outside is 0
  double w = 1;      // likewise
};

// Without rounding the image is any grid point within a spacing, and the place itself is known up to its radius.
struct UnroundedVertex {
  ProjectedVertex projected;
  CertifiedPlace place;  // where strictly_outside is 0
};
[[nodiscard]] UnroundedVertex project_unrounded(const CutMesh& mesh, VertexId vertex, const Camera& camera,
                                                int grid_bits);

[[nodiscard]] ProjectedVertex project_vertex(const Point3& vertex, const Camera& camera, int grid_bits);

// Projects a vertex of a mesh in the same way; one that cutting made goes through the exact tier.
[[nodiscard]] ProjectedVertex project_vertex(const CutMesh& mesh, VertexId vertex, const Camera& camera, int grid_bits);

namespace projection_tiers {
// The result is empty where the error bound does not decide every bound and the rounding.
[[nodiscard]] std::optional<ProjectedVertex> filtered(const Point3& vertex, const Camera& camera, int grid_bits);
[[nodiscard]] ProjectedVertex exact(const Point3& vertex, const Camera& camera, int grid_bits);
}  // namespace projection_tiers

}  // namespace sightline::inline geometry
