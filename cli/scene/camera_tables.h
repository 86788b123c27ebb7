// One [[camera]] of a scene file.
//
// A camera has a name and exactly one of these forms (units of the mesh, angles in degrees, images in pixels):
//   window         fov_y_deg, fov_x_deg, focal_length_mm with sensor_mm, or orthographic_height; eye and target, or
//                  camera_to_world and axes; and optionally up, aspect, shift, near, far
//   matrix         P (3x4), image, and optionally pixel_origin, image_y, near, far
//   calibrated     K (3x3), R (3x3) and t (3), or camera_to_world and axes; image, and optionally pixel_origin, image_y, near, far
// Errors: InputError with file and line, also for a camera that defines no view.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "cli/scene/toml_reader.h"
#include "geometry/projection/camera.h"

namespace sightline::cli {

[[nodiscard]] Camera read_camera(const TomlReader& table);

// What the keys of a window say. The height is the whole window's where rays are parallel, else half of it at distance 1.
struct WindowKeys {
  Projection projection = Projection::perspective;
  double height = 1;
  double aspect = 1;
  std::array<double, 2> shift{};
};

// Precondition: exactly one of fov_y_deg, fov_x_deg, focal_length_mm, orthographic_height is there: `form`.
[[nodiscard]] WindowKeys read_window(const TomlReader& table, std::string_view form);

// The view's own aspect does not count.
[[nodiscard]] Camera window_camera(const std::string& name, ViewPoint view, const WindowKeys& window);

// Nothing where the table does not say; the words are those of scene files.
[[nodiscard]] std::optional<PixelOrigin> read_pixel_origin(const TomlReader& table);
[[nodiscard]] std::optional<CameraAxes> read_axes(const TomlReader& table);

}  // namespace sightline::cli
