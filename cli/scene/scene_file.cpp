#include "cli/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include "cli/scene/mesh_tables.h"
#include "cli/scene/scene_tables.h"
#include "cli/scene/toml_reader.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"
#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::cli {

namespace {

constexpr std::size_t longest_file = std::size_t{64} << 20;
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
    throw InputError(path, error.source().begin.line,
                     fmt::format("not valid TOML: {}", printable(error.description(), longest_description)));
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

std::vector<Camera> read_cameras(const toml::table& root, const std::string& path) {
  const toml::array* elements = table_array(root, path, "camera");
  if (elements == nullptr) throw InputError(path, 0, "there is no [[camera]]; add at least one");
  if (elements->empty())
    throw InputError(path, elements->source().begin.line, "there is no [[camera]]; add at least one");
  return read_tables<Camera>(*elements, path, "camera", read_camera);
}

std::vector<Panel> read_panels(const toml::table& root, const std::string& path) {
  const toml::array* elements = table_array(root, path, "panel");
  if (elements == nullptr) return {};
  std::vector<Panel> panels = read_tables<Panel>(*elements, path, "panel", read_panel);
  if (panels.size() <= most_panels) return panels;
  throw InputError(path, elements->get(most_panels)->source().begin.line,
                   fmt::format("more than {} panels", most_panels));
}

ReflectionOptions read_reflection(const toml::table& root, const std::string& path) {
  const toml::node* node = root.get("reflection");
  if (node == nullptr) return {};
  const std::size_t line = node->source().begin.line;
  if (!node->is_table()) throw InputError(path, line, "'reflection' must be a table: [reflection]");
  return read_reflection(TomlReader{*node->as_table(), path, "[reflection]", line});
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
  const toml::table root = parsed(text, path);
  TomlReader(root, path, "the scene file", 0).allow_only({"mesh", "regions", "camera", "panel", "reflection"});
  SceneMeshes surface = read_meshes(root, path);
  SceneDescription scene;
  scene.file = path;
  scene.mesh_file = surface.meshes.front().file;
  scene.meshes = std::move(surface.meshes);
  scene.sides = surface.sides;
  scene.cameras = read_cameras(root, path);
  scene.panels = read_panels(root, path);
  scene.reflection = read_reflection(root, path);
  scene.regions = read_regions(root, path);
  return scene;
}

SceneDescription read_scene_file(const std::string& path) {
  const auto unreadable = [&](int cause) {
    return InputError(path, 0, fmt::format("the scene file cannot be read: {}", std::strerror(cause)));
  };
  if (std::filesystem::is_directory(path)) throw unreadable(EISDIR);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw unreadable(errno);
  std::string text;
  for (std::string chunk(1 << 16, '\0'); file.read(chunk.data(), 1 << 16), file.gcount() > 0;) {
    text.append(chunk, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > longest_file)
      throw InputError(path, 0, fmt::format("a scene file has at most {} bytes", longest_file));
  }
  if (file.bad()) throw unreadable(EIO);
  return parse_scene(text, path);
}

}  // namespace sightline::cli
