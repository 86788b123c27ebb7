// The tables of a scene file that are about its surface: [mesh] or [[mesh]], [regions], and the mirrors of [reflection].
//
// In:  the scene file's root; what is relative to it, and messages, have its path.
// Out: meshes, where each is placed, and which regions are chosen for what.
// Errors: InputError with file and line: also for a placement that is no 3x4 or 4x4 matrix or is singular, and for meshes that
// are called alike.
#pragma once

#include "cli/scene/scene_mesh.h"
#include "cli/scene/toml_reader.h"
#include "geometry/projection/culling.h"

namespace sightline::cli {

struct SceneMeshes {
  std::vector<SceneMesh> meshes;  // at least one
  SidesPolicy sides = SidesPolicy::automatic;
};

[[nodiscard]] SceneMeshes read_meshes(const toml::table& root, const std::string& path);

[[nodiscard]] SceneRegions read_regions(const toml::table& root, const std::string& path);

}  // namespace sightline::cli
