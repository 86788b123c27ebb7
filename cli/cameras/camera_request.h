// What a scene file says about a camera file, beside its name.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "cli/cameras/camera_record.h"

namespace sightline::cli {

enum class PoseDirection { camera_to_world, world_to_camera };

struct CameraRequest {
  std::string file;                           // a path that can be opened
  std::optional<std::string> intrinsics;      // likewise, of the file with the calibration where `file` has poses
  std::optional<std::array<double, 2>> size;  // of the image, where the file does not say it
  std::optional<PixelOrigin> origin;          // in place of what is usual in the format
  std::optional<LensModel> lens_model;        // of OpenCV's files, which do not say it
  std::optional<PoseDirection> direction;     // of a table's quaternions, and their axes
  std::optional<CameraAxes> axes;
  std::optional<WindowShape> window;   // of cameras whose file has poses only
  std::optional<WorldToCamera> place;  // of the camera, where its file does not say it
};

// Returns the text of the file at a path. Errors: InputError where it cannot be read.
using FileSource = std::function<std::string(const std::string& path)>;

// Returns the size of the image from what the file has (0 where it has none) and what was asked for.
// Errors: InputError where both say different things, or one is not positive.
[[nodiscard]] std::array<double, 2> image_size(const std::array<double, 2>& in_file, const CameraRequest& request,
                                               const std::string& file, std::size_t line);

}  // namespace sightline::cli
