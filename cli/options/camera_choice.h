// Which of a scene's cameras a command is about.
//
// Errors: CommandLineError with the names that there are.
#pragma once

#include <string>

#include "cli/scene/scene_file.h"

namespace sightline::cli {

[[nodiscard]] const Camera& camera_named(const SceneDescription& scene, const std::string& name);

// Where a scene has several, one has to be named.
[[nodiscard]] const Camera& only_camera(const SceneDescription& scene);

}  // namespace sightline::cli
