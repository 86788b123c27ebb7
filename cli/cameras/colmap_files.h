// COLMAP's text files: cameras.txt, the calibrations, and images.txt, the poses.
//
// In:  the texts. Out: of cameras.txt a calibration per camera, by its id; of images.txt a camera per image.
// Pixel (0.5, 0.5) is the first pixel's centre. An image has two lines: IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, world to
// camera, with a name that may have blanks; and its points, which are passed over. Lines that begin with # are comments.
// Lens models: SIMPLE_PINHOLE, PINHOLE; SIMPLE_RADIAL, RADIAL, OPENCV, FULL_OPENCV (brown); OPENCV_FISHEYE,
// SIMPLE_RADIAL_FISHEYE, RADIAL_FISHEYE (fisheye).
// Errors: InputError with the line: another model, a wrong number of fields, an id that is there twice or not at all.
// Source: COLMAP's documentation, "Output Format" and "Camera Models".
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "cli/cameras/camera_request.h"

namespace sightline::cli {

struct ColmapCamera {
  Calibration calibration;
  std::size_t line = 0;
};

using ColmapCameras = std::map<std::int64_t, ColmapCamera>;

[[nodiscard]] ColmapCameras read_colmap_cameras(std::string_view text, const std::string& file,
                                                const CameraRequest& request);

[[nodiscard]] std::vector<CameraRecord> read_colmap_images(std::string_view text, const std::string& file,
                                                           const ColmapCameras& cameras,
                                                           const std::string& cameras_file);

}  // namespace sightline::cli
