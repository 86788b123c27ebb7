// The options that make a camera for a mesh; a scene file has its own.
//
// Errors: CommandLineError: a mesh without a camera, a scene with one, a value that is none.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "geometry/projection/camera.h"

namespace sightline::cli {

struct CameraTexts {
  std::string eye, target, up, fov_y, aspect;
};

void declare_camera(CLI::App& command, CameraTexts& texts);

[[nodiscard]] bool is_scene_file(const std::string& input);

// None where the input is a scene file.
[[nodiscard]] std::optional<Camera> camera_of(const std::string& input, const CameraTexts& texts);

}  // namespace sightline::cli
