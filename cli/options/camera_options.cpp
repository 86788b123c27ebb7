#include "cli/options/camera_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/options/option_values.h"
#include "cli/options/requests.h"

namespace sightline::cli {

namespace {

double parsed_angle(const std::string& text, const char* option) {
  const double degrees = parsed_number(text, option);
  if (!(degrees > 0 && degrees < 180))
    throw CommandLineError(
        fmt::format("{}: '{}' is no field of view between 0 and 180 degrees; give one that is", option, text));
  return degrees;
}

// Half the window's height at distance 1.
double half_height_of(const CameraTexts& texts, double aspect) {
  if (texts.fov_x.empty()) return tangent_of_half(parsed_angle(texts.fov_y, "--fov-y"));
  if (!texts.fov_y.empty()) throw CommandLineError("there are --fov-y and --fov-x; give one");
  return tangent_of_half(parsed_angle(texts.fov_x, "--fov-x")) / aspect;
}

Camera camera_for_mesh(const CameraTexts& texts) {
  if (texts.eye.empty() || texts.target.empty() || (texts.fov_y.empty() && texts.fov_x.empty())) {
    throw CommandLineError("a mesh needs a camera; give --eye, --target and --fov-y, or a scene file (.toml)");
  }
  ViewPoint view;
  view.eye = parsed_vector(texts.eye, "--eye");
  view.target = parsed_vector(texts.target, "--target");
  if (!texts.up.empty()) view.up = parsed_vector(texts.up, "--up");
  if (!texts.aspect.empty()) view.aspect = parsed_number(texts.aspect, "--aspect");
  try {
    return pinhole_camera("view", view, half_height_of(texts, view.aspect));
  } catch (const CameraError& error) {
    throw CommandLineError(error.what());
  }
}

void refuse_camera(const CameraTexts& texts) {
  for (const std::string* text : {&texts.eye, &texts.target, &texts.up, &texts.fov_y, &texts.fov_x, &texts.aspect}) {
    if (!text->empty()) {
      throw CommandLineError(
          "--eye, --target, --up, --fov-y, --fov-x and --aspect go with a mesh, and a scene file has its own cameras; "
          "leave them out");
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
  command.add_option("--fov-x", texts.fov_x, "the horizontal one instead")->type_name("DEG");
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
