// A camera as a file has it: what is known of it there, before it is a Camera.
//
// Files have a calibration, a pose, or both; a scene file adds what is missing. Units: pixels, and the input's of length.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/projection/camera.h"
#include "geometry/projection/lens.h"

namespace sightline::cli {

// Pixels have x to the right and y down. width and height are 0 where the file does not say them.
struct Calibration {
  Matrix3 k = Matrix3::Identity();
  double width = 0;
  double height = 0;
  PixelOrigin origin = PixelOrigin::corner;
  std::optional<Lens> lens;
};

// A place v of the world is at R v + t in the camera's frame: x right, y down, z along the view.
struct WorldToCamera {
  Matrix3 r = Matrix3::Identity();
  Vector3 t = Vector3::Zero();
};

// A window instead of pixels: half its height at distance 1.
struct WindowShape {
  double half_height = 1;
  double aspect = 1;
};

struct CameraRecord {
  std::string name;      // as the file has it, which may be no folder's name
  std::size_t line = 0;  // of the file
  std::variant<std::monostate, Calibration, WindowShape> image;
  std::variant<std::monostate, WorldToCamera, CameraPose, ViewPoint> place;
};

// What a scene file says of all cameras of a file.
struct ViewLimits {
  std::optional<double> near_distance;
  std::optional<double> far_distance;
  double frame_tolerance = default_frame_tolerance;  // of those with a lens
};

// The camera of a record, called `name`.
// Errors: CameraError where image or place is missing, where the image has no size, where these define no view, and for
// a lens that folds.
[[nodiscard]] Camera camera_of(const CameraRecord& record, const std::string& name, const ViewLimits& limits);

// Returns STEM-01 for the first of `count`; with as many digits as the last needs.
[[nodiscard]] std::string numbered(const std::string& stem, std::size_t index, std::size_t count);

}  // namespace sightline::cli
