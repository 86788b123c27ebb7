// Files that have cameras: what one is, is told by how it begins, not by its name.
//
// In:  a request, and what gives the text of a file. Out: the cameras in it, in file order.
//   {                   transforms.json where there are frames, else OpenCV's JSON (transforms_file.h, opencv_file.h)
//   <                   OpenCV's XML
//   %YAML, ---, key:    OpenCV's YAML
//   a number, numbers   COLMAP's images.txt (colmap_files.h); cameras.txt is beside it, unless the request names it
//   a number, a word    COLMAP's cameras.txt
//   words with commas   a table of poses, CSV (pose_table.h)
// Poses without a calibration get that of the file of intrinsics: the only camera in it.
// Errors: InputError with file and line: a file that is none of these, what its reader refuses, a file with several
// calibrations as intrinsics.
#pragma once

#include <vector>

#include "cli/cameras/camera_request.h"

namespace sightline::cli {

[[nodiscard]] std::vector<CameraRecord> read_camera_file(const CameraRequest& request, const FileSource& files);

}  // namespace sightline::cli
