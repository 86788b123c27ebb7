#include "cli/options/camera_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/options/requests.h"

namespace sightline::cli {

namespace {

std::string names_of_cameras(const SceneDescription& scene) {
  std::string names;
  for (const Camera& camera : scene.cameras) names += (names.empty() ? "" : ", ") + camera.name;
  return names;
}

}  // namespace

const Camera& camera_named(const SceneDescription& scene, const std::string& name) {
  const auto has_name = [&name](const Camera& camera) { return camera.name == name; };
  const auto found = std::find_if(scene.cameras.begin(), scene.cameras.end(), has_name);
  if (found == scene.cameras.end())
    throw CommandLineError(fmt::format("--camera: the scene has no '{}'; it has {}", name, names_of_cameras(scene)));
  return *found;
}

const Camera& only_camera(const SceneDescription& scene) {
  if (scene.cameras.size() == 1) return scene.cameras.front();
  throw CommandLineError("the scene has several cameras: choose one with --camera, of " + names_of_cameras(scene));
}

}  // namespace sightline::cli
