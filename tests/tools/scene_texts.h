// Scene files and the files of cameras beside them, in memory.
#pragma once

#include <map>
#include <string>

#include "cli/scene/scene_file.h"

namespace sightline::tests {

// Paths are as a scene file "dir/scene.toml" finds them: a file "a.yml" beside it is "dir/a.yml".
using FileTexts = std::map<std::string, std::string>;

// Returns the scene of [mesh] and what follows it. Errors: InputError, also for a file that is not among the texts.
[[nodiscard]] cli::SceneDescription scene_of(const std::string& cameras, const FileTexts& files);

}  // namespace sightline::tests
