// A table of cameras: CSV, whose first line names the columns.
//
// In:  the text. Out: a camera per line, called as its `name`, or camera-01 and so on where there is no such column.
// Columns, in any order; of each form all:
//   eye_x, eye_y, eye_z, target_x, target_y, target_z, and optionally up_x, up_y, up_z (0, 1, 0)
//   tx, ty, tz, qw, qx, qy, qz: a translation and a quaternion (Hamilton's), of which the request says the direction (the pose of
//      the camera in the world, or of the world in the camera) and the camera's axes
//   fov_y_deg or fov_x_deg, and aspect (1): the window, where the request has no intrinsics
// Fields are numbers, a name may stand in quotes (""" is one in it). Empty lines, and those that begin with #, are passed over.
// Errors: InputError with the line: a column that is unknown, missing or there twice, a wrong number of fields, no number.
#pragma once

#include <string_view>
#include <vector>

#include "cli/cameras/camera_request.h"

namespace sightline::cli {

[[nodiscard]] std::vector<CameraRecord> read_pose_table(std::string_view text, const std::string& file,
                                                        const CameraRequest& request);

}  // namespace sightline::cli
