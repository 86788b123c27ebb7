// A face gets its colour by how it is turned to the camera: a lamp stands above the camera's left shoulder.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline formats {

using Colour = std::array<std::uint8_t, 3>;

struct FaceShade {
  Colour fill;
  Colour stroke;  // darker
};

// Fronts are blue, backs are sand-coloured.
[[nodiscard]] FaceShade face_shade(const CutMesh& mesh, const Camera& camera, FacetId facet, FacetFacing facing);

}  // namespace sightline::inline formats
