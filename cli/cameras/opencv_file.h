// Calibrations as OpenCV's programs write them: cv::FileStorage in YAML, XML or JSON, and the camera_info of ROS.
//
// In:  the document. Out: its cameras; pixel (0, 0) is the first pixel's centre.
//   camera_matrix, distortion_coefficients, image_width and image_height, or image_size: one calibration. Capitals and
//      underscores in keys do not matter; cameraMatrix, K, mtx, dist_coeffs, D are known, too.
//   Its poses, world to camera: rvec and tvec, or R and T; or each row of extrinsic_parameters, a rotation vector and a
//      translation: cameras view-01 and so on. None: a record without a place.
//   Stereo: cameraMatrix1 and 2 or M1 and M2, likewise the coefficients, and R and T of the second camera: cameras
//      camera-01, which is at the origin, and camera-02. A file with P1 and P2 and without these has the rectified two.
// Coefficients are k1 k2 p1 p2, and k3, and k4 k5 k6, and zeros for prism and tilt; where `fisheye_model` or the request says
// so, k1 k2 k3 k4 of a fisheye.
// Errors: InputError with the line: a matrix that is missing or has the wrong size, other lens models.
// Source: OpenCV 4, cv::FileStorage, and samples/cpp/calibration.cpp, stereo_calib.cpp.
#pragma once

#include <vector>

#include "cli/cameras/camera_request.h"
#include "cli/cameras/document.h"

namespace sightline::cli {

[[nodiscard]] std::vector<CameraRecord> read_opencv(const DocumentNode& root, const std::string& file,
                                                    const CameraRequest& request);

}  // namespace sightline::cli
