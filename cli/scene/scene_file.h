// Scene files (TOML): which mesh, the cameras, and the panels. docs/scene-files.md describes the format.
//
// In:  the path of a scene file. Out: a Scene; paths in the file are relative to the file's folder.
// Errors: InputError with file and line: no such file, more than 64 MiB, TOML that does not parse, a line with more than
// 1000 dots, a key that is unknown, missing or of the wrong type, twice the same name, a camera that defines no view, a
// panel that is no planar polygon.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/scene/scene.h"

namespace sightline::cli {

[[nodiscard]] Scene read_scene_file(const std::string& path);

// The same for a text in memory; path is for messages and for what is relative to it.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& path);

// A scene file, or, where a camera comes with it, a mesh that this camera sees.
[[nodiscard]] Scene read_scene(const std::string& input, const std::optional<Camera>& mesh_camera);

// "auto", "front" or "both"; nothing for another word.
[[nodiscard]] std::optional<SidesPolicy> sides_policy(std::string_view word);

}  // namespace sightline::cli
