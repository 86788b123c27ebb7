#include "cli/options/camera_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/options/option_values.h"
#include "cli/options/requests.h"

namespace sightline::cli {

namespace {

Camera camera_for_mesh(const CameraTexts& texts) {
  if (texts.eye.empty() || texts.target.empty() || texts.fov_y.empty()) {
    throw CommandLineError("a mesh needs a camera; give --eye, --target and --fov-y, or a scene file (.toml)");
  }
  ViewPoint view;
  view.eye = parsed_vector(texts.eye, "--eye");
  view.target = parsed_vector(texts.target, "--target");
  if (!texts.up.empty()) view.up = parsed_vector(texts.up, "--up");
  if (!texts.aspect.empty()) view.aspect = parsed_number(texts.aspect, "--aspect");
  try {
    return perspective_camera("view", view, parsed_number(texts.fov_y, "--fov-y"));
  } catch (const CameraError& error) {
    throw CommandLineError(error.what());
  }
}

void refuse_camera(const CameraTexts& texts) {
  for (const std::string* text : {&texts.eye, &texts.target, &texts.up, &texts.fov_y, &texts.aspect}) {
    if (!text->empty()) {
      throw CommandLineError(
          "--eye, --target, --up, --fov-y and --aspect go with a mesh, and a scene file has its own cameras; leave "
          "them out");
    }
  }
}

std::string names_of_cameras(const SceneDescription& scene) {
  std::string names;
  for (const Camera& camera : scene.cameras) names += (names.empty() ? "" : ", ") + camera.name;
  return names;
}

}  // namespace

void declare_camera(CLI::App& command, CameraTexts& texts) {
  command.add_option("--eye", texts.eye, "where the camera is")->type_name("X,Y,Z");
  command.add_option("--target", texts.target, "what it looks at")->type_name("X,Y,Z");
  command.add_option("--up", texts.up, "what is up (0,1,0)")->type_name("X,Y,Z");
  command.add_option("--fov-y", texts.fov_y, "vertical field of view in degrees")->type_name("DEG");
  command.add_option("--aspect", texts.aspect, "the window's width over its height (1)")->type_name("R");
}

bool is_scene_file(const std::string& input) { return input.ends_with(".toml") || input.ends_with(".TOML"); }

std::optional<Camera> camera_of(const std::string& input, const CameraTexts& texts) {
  if (!is_scene_file(input)) return camera_for_mesh(texts);
  refuse_camera(texts);
  return std::nullopt;
}

const Camera& camera_named(const SceneDescription& scene, const std::string& name) {
  const auto has_name = [&name](const Camera& camera) { return camera.name == name; };
  const auto found = std::find_if(scene.cameras.begin(), scene.cameras.end(), has_name);
  if (found == scene.cameras.end())
    throw CommandLineError(
        fmt::format("--camera: the scene has no '{}'; it has {}; choose one", name, names_of_cameras(scene)));
  return *found;
}

const Camera& only_camera(const SceneDescription& scene) {
  if (scene.cameras.size() == 1) return scene.cameras.front();
  throw CommandLineError("the scene has several cameras; choose one with --camera, of " + names_of_cameras(scene));
}

}  // namespace sightline::cli
