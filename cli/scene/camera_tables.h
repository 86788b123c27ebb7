// One [[camera]] of a scene file.
//
// A camera has a name and exactly one of these forms (units of the mesh, angles in degrees, images in pixels):
//   pinhole        eye, target, fov_y_deg, and optionally up, aspect, near, far
//   orthographic   eye, target, orthographic_height, and optionally up, aspect, near, far
//   matrix         P (3x4), image, and optionally pixel_origin, near, far
//   calibrated     K (3x3), R (3x3), t (3), image, and optionally pixel_origin, near, far
// Errors: InputError with file and line, also for a camera that defines no view.
#pragma once

#include "cli/scene/toml_reader.h"
#include "geometry/projection/camera.h"

namespace sightline::cli {

[[nodiscard]] Camera read_camera(const TomlReader& table);

}  // namespace sightline::cli
