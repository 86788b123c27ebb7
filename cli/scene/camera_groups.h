// One [[cameras]] of a scene file: the cameras of a file, or of a rig.
//
// A group has exactly one of
//   file     (camera_files.h), relative to the scene file; and optionally intrinsics, another file; select (names) or every (n: the
//            first, and each n-th after it); image, pixel_origin, lens_model, frame_tolerance; R and t; for a table pose, axes, and a field of view
//   ring, sphere, grid   (camera_rigs.h): a table; and a field of view, aspect, shift
// and optionally prefix, near, far. A camera is called as in the file or the rig, made a folder's name (camera_names.h), behind the
// prefix.
// Errors: InputError with file and line: of the camera file where it is wrong, else of the scene file.
#pragma once

#include <vector>

#include "cli/cameras/camera_request.h"
#include "cli/scene/toml_reader.h"
#include "geometry/projection/camera.h"

namespace sightline::cli {

// No group has more cameras.
constexpr std::size_t most_group_cameras = 100000;

// scene_file: what paths are relative to.
[[nodiscard]] std::vector<Camera> read_camera_group(const TomlReader& table, const std::string& scene_file,
                                                    const FileSource& files);

}  // namespace sightline::cli
