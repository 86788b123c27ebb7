// transforms.json of Blender's NeRF export, instant-ngp and nerfstudio.
//
// In:  the document. Out: a camera per frame, called as its file_path.
// transform_matrix (4x4, or its first three rows) is camera to world; the camera's x is to the right, its y up, and it looks along -z.
// Intrinsics are fl_x, fl_y, cx, cy, w, h; or camera_angle_x, the horizontal angle in radians, with square pixels unless there is
// camera_angle_y; cx and cy are the middle where they are missing. The lens is k1 to k4 (k1 to k6 where it is no fisheye), p1 and p2;
// a fisheye where is_fisheye is true or camera_model is OPENCV_FISHEYE. A frame's own intrinsics come before the file's.
// Pixel (0.5, 0.5) is the first pixel's centre.
// Errors: InputError with the line: no frames, a frame without a matrix, no focal length, another camera model.
#pragma once

#include <vector>

#include "cli/cameras/camera_request.h"
#include "cli/cameras/document.h"

namespace sightline::cli {

[[nodiscard]] std::vector<CameraRecord> read_transforms(const DocumentNode& root, const std::string& file,
                                                        const CameraRequest& request);

}  // namespace sightline::cli
