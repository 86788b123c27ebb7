#include "cli/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "cli/scene/camera_groups.h"
#include "cli/scene/camera_tables.h"
#include "cli/scene/coincidence_table.h"
#include "cli/scene/mesh_tables.h"
#include "cli/scene/panel_table.h"
#include "cli/scene/reflection_table.h"
#include "cli/scene/toml_reader.h"
#include "cli/system/whole_file.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"
#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::cli {

namespace {

constexpr std::ptrdiff_t most_dots = 1000;
constexpr std::size_t longest_description = 300;  // of what is wrong with a TOML text

// The parser recurses into dotted keys, as deep as they go: a.a.a and so on for 10^5 times would be the end of its
// stack. No scene has reason for a line with so many dots, wherever they stand.
void refuse_deep_keys(std::string_view text, const std::string& path) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    if (std::ranges::count(text.substr(0, end), '.') > most_dots)
      throw InputError(path, line, fmt::format("more than {} dots in one line; divide it", most_dots));
    text.remove_prefix(end);
  }
}

toml::table parsed(std::string_view text, const std::string& path) {
  refuse_deep_keys(text, path);
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw InputError(
        path, error.source().begin.line,
        fmt::format("not valid TOML: {}; correct it", printable(error.description(), longest_description)));
  }
}

// Reads the elements of [[camera]] or [[panel]], which have distinct names.
template <class Item, class Read>
std::vector<Item> read_tables(const toml::array& elements, const std::string& path, const std::string& kind,
                              Read read) {
  std::vector<Item> items;
  std::set<std::string> names;
  for (const toml::node& element : elements) {
    const std::size_t line = element.source().begin.line;
    if (!element.is_table())
      throw InputError(path, line, fmt::format("'{}' must be an array of tables: [[{}]]", kind, kind));
    const TomlReader table{*element.as_table(), path, "[[" + kind + "]]", line};
    items.push_back(read(table));
    const std::string& name = items.back().name;
    if (!names.insert(name).second)
      table.fail("name", fmt::format("a second {} is called \"{}\"; names must be distinct", kind, name));
  }
  return items;
}

// Null where there are none.
const toml::array* table_array(const toml::table& root, const std::string& path, const std::string& kind) {
  const toml::node* node = root.get(kind);
  if (node == nullptr) return nullptr;
  if (!node->is_array()) {
    throw InputError(path, node->source().begin.line,
                     fmt::format("'{}' must be an array of tables: [[{}]]", kind, kind));
  }
  return node->as_array();
}

// Adds the cameras of each [[cameras]]; names are distinct among all.
void add_camera_groups(const toml::table& root, const std::string& path, const FileSource& files,
                       std::vector<Camera>& cameras) {
  const toml::array* elements = table_array(root, path, "cameras");
  if (elements == nullptr) return;
  std::set<std::string> names;
  for (const Camera& camera : cameras) names.insert(camera.name);
  for (const toml::node& element : *elements) {
    const std::size_t line = element.source().begin.line;
    if (!element.is_table()) throw InputError(path, line, "'cameras' must be an array of tables: [[cameras]]");
    const TomlReader table{*element.as_table(), path, "[[cameras]]", line};
    for (Camera& camera : read_camera_group(table, path, files)) {
      if (!names.insert(camera.name).second)
        table.fail(fmt::format("a second camera is called \"{}\"; set another prefix", camera.name));
      cameras.push_back(std::move(camera));
    }
  }
}

std::vector<Camera> read_cameras(const toml::table& root, const std::string& path, const FileSource& files) {
  std::vector<Camera> cameras;
  const toml::array* elements = table_array(root, path, "camera");
  if (elements != nullptr) cameras = read_tables<Camera>(*elements, path, "camera", read_camera);
  add_camera_groups(root, path, files, cameras);
  if (cameras.empty()) {
    throw InputError(path, elements == nullptr ? 0 : elements->source().begin.line,
                     "there is no [[camera]]; add at least one, or [[cameras]] of a file");
  }
  return cameras;
}

std::vector<Panel> read_panels(const toml::table& root, const std::string& path) {
  const toml::array* elements = table_array(root, path, "panel");
  if (elements == nullptr) return {};
  std::vector<Panel> panels = read_tables<Panel>(*elements, path, "panel", read_panel);
  if (panels.size() <= most_panels) return panels;
  throw InputError(path, elements->get(most_panels)->source().begin.line,
                   fmt::format("more than {} panels; leave some out", most_panels));
}

// Nothing where there is no such table.
std::optional<TomlReader> table_called(const toml::table& root, const std::string& path, const std::string& name) {
  const toml::node* node = root.get(name);
  if (node == nullptr) return std::nullopt;
  const std::size_t line = node->source().begin.line;
  if (!node->is_table()) throw InputError(path, line, fmt::format("'{}' must be a table: [{}]", name, name));
  return TomlReader{*node->as_table(), path, "[" + name + "]", line};
}

ReflectionOptions read_reflection(const toml::table& root, const std::string& path) {
  ReflectionOptions options;
  if (const auto table = table_called(root, path, "reflection")) options = read_reflection(*table);
  if (const auto table = table_called(root, path, "coincidence")) read_coincidence(*table, options);
  return options;
}

}  // namespace

SceneDescription read_scene(const std::string& input, const std::optional<Camera>& mesh_camera) {
  if (!mesh_camera) return read_scene_file(input);
  return {input, input, {{input, "", {}}}, {}, SidesPolicy::automatic, {*mesh_camera}, {}, {}};
}

const char* to_string(SidesPolicy policy) {
  if (policy == SidesPolicy::automatic) return "auto";
  return policy == SidesPolicy::front ? "front" : "both";
}

std::optional<SidesPolicy> sides_policy(std::string_view word) {
  for (const SidesPolicy policy : {SidesPolicy::automatic, SidesPolicy::front, SidesPolicy::both}) {
    if (word == to_string(policy)) return policy;
  }
  return std::nullopt;
}

SceneDescription parse_scene(std::string_view text, const std::string& path) {
  return parse_scene(text, path, [](const std::string& file) { return whole_file(file, "the file of cameras"); });
}

SceneDescription parse_scene(std::string_view text, const std::string& path, const FileSource& files) {
  const toml::table root = parsed(text, path);
  TomlReader(root, path, "the scene file", 0)
      .allow_only({"mesh", "regions", "camera", "cameras", "panel", "reflection", "coincidence"});
  SceneMeshes surface = read_meshes(root, path);
  SceneDescription scene;
  scene.file = path;
  scene.mesh_file = surface.meshes.front().file;
  scene.meshes = std::move(surface.meshes);
  scene.sides = surface.sides;
  scene.cameras = read_cameras(root, path, files);
  scene.panels = read_panels(root, path);
  scene.reflection = read_reflection(root, path);
  scene.regions = read_regions(root, path);
  return scene;
}

SceneDescription read_scene_file(const std::string& path) {
  return parse_scene(whole_file(path, "the scene file"), path);
}

}  // namespace sightline::cli
