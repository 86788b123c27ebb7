// Which camera a command is about: one of a scene's, or for a mesh, which has none, one that options make.
//
// Errors: CommandLineError: a mesh without a camera, a scene with one from the options, a value that is none, a name that
// no camera has, with the names that there are.
#pragma once

#include <optional>
#include <string>

#include "cli/scene/scene_file.h"
#include "geometry/projection/camera.h"

namespace CLI {
class App;
}

namespace sightline::cli {

struct CameraTexts {
  std::string eye, target, up, fov_y, fov_x, aspect;
};

void declare_camera(CLI::App& command, CameraTexts& texts);

[[nodiscard]] bool is_scene_file(const std::string& input);

// None where the input is a scene file.
[[nodiscard]] std::optional<Camera> camera_of(const std::string& input, const CameraTexts& texts);

[[nodiscard]] const Camera& camera_named(const SceneDescription& scene, const std::string& name);

// Where a scene has several, one has to be named.
[[nodiscard]] const Camera& only_camera(const SceneDescription& scene);

}  // namespace sightline::cli
