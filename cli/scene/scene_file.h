// Scene files (TOML): which meshes, the cameras, and the panels. docs/scene-files.md describes the format.
//
// In:  the path of a scene file. Out: a SceneDescription; paths in the file are relative to the file's folder.
// Errors: InputError with file and line: no such file, more than 64 MiB, TOML that does not parse, a line with more than
// 1000 dots, a key that is unknown, missing or of the wrong type, twice the same name, a camera that defines no view, a
// panel that is no planar polygon.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/cameras/camera_request.h"
#include "cli/scene/scene_mesh.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/culling.h"
#include "reflect/world/panel.h"
#include "reflect/world/reflection_options.h"

namespace sightline::cli {

struct SceneDescription {
  std::string file;       // the scene file, or the mesh file where the camera came from the command line
  std::string mesh_file;  // the first mesh's path, which can be opened from the working directory
  std::vector<SceneMesh> meshes;
  SceneRegions regions;
  SidesPolicy sides = SidesPolicy::automatic;
  std::vector<Camera> cameras;  // at least one; names are distinct and safe folder names
  std::vector<Panel> panels;    // names are distinct, and one word each
  ReflectionOptions reflection;
};

[[nodiscard]] SceneDescription read_scene_file(const std::string& path);

// The same for a text in memory; path is for messages and for what is relative to it. files: gives what camera files have.
[[nodiscard]] SceneDescription parse_scene(std::string_view text, const std::string& path, const FileSource& files);
[[nodiscard]] SceneDescription parse_scene(std::string_view text, const std::string& path);

// A scene file, or, where a camera comes with it, a mesh that this camera sees.
[[nodiscard]] SceneDescription read_scene(const std::string& input, const std::optional<Camera>& mesh_camera);

// In the words of scene files and options: "auto", "front" or "both"; nothing for another word.
[[nodiscard]] const char* to_string(SidesPolicy policy);
[[nodiscard]] std::optional<SidesPolicy> sides_policy(std::string_view word);

}  // namespace sightline::cli
