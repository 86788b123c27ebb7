#include "cli/scene/mesh_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cli/scene/result_names.h"
#include "cli/scene/scene_file.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

struct Unit {
  const char* name;
  LengthRatio metres;
};

constexpr std::array units{Unit{"mm", {1, 1000}}, Unit{"cm", {1, 100}}, Unit{"m", {1, 1}}, Unit{"in", {127, 5000}},
                           Unit{"ft", {381, 1250}}};

// The tables of the meshes, and whether they are an array.
struct MeshTables {
  std::vector<TomlReader> tables;
  bool is_array = false;
};

MeshTables mesh_tables(const toml::table& root, const std::string& path) {
  const toml::node* node = root.get("mesh");
  if (node == nullptr) throw InputError(path, 0, "there is no [mesh]; add [mesh] with file = \"...\"");
  const std::size_t line = node->source().begin.line;
  if (node->is_table()) return {{TomlReader(*node->as_table(), path, "[mesh]", line)}, false};
  if (!node->is_array() || node->as_array()->empty())
    throw InputError(path, line, "'mesh' must be a table, [mesh], or an array of tables, [[mesh]]");
  MeshTables result{{}, true};
  for (const toml::node& element : *node->as_array()) {
    const std::size_t element_line = element.source().begin.line;
    if (!element.is_table())
      throw InputError(path, element_line, "'mesh' must be a table, [mesh], or an array of tables, [[mesh]]");
    result.tables.emplace_back(*element.as_table(), path, "[[mesh]]", element_line);
  }
  return result;
}

SidesPolicy read_sides(const TomlReader& mesh) {
  const auto policy = sides_policy(mesh.text("sides"));
  if (!policy) mesh.fail("sides", "'sides' must be \"auto\", \"front\" or \"both\"");
  return *policy;
}

std::string read_file_name(const TomlReader& mesh) {
  std::string name = mesh.text("file");
  if (name.find('\0') != std::string::npos)
    mesh.fail("file", "'file' has a NUL character, and no file is called so; remove it");
  return name;
}

// In an array a mesh that is given no name has that of its file.
std::string read_mesh_name(const TomlReader& mesh, const std::string& file, bool is_array) {
  if (!is_array && !mesh.has("name")) return "";
  const bool is_given = mesh.has("name");
  const std::string name = is_given ? mesh.text("name") : std::filesystem::path(file).stem().string();
  if (const auto defect = name_defect(name))
    mesh.fail(is_given ? "name" : "file",
              fmt::format("the mesh's name, \"{}\", {}; give it another 'name'", printable(name), *defect));
  return name;
}

Matrix34 read_placement(const TomlReader& mesh) {
  const auto rows = mesh.rows<4>("placement");
  if (rows.size() != 3 && rows.size() != 4)
    mesh.fail("placement", "'placement' must be a matrix of 3 or 4 rows with 4 entries each");
  if (rows.size() == 4 && rows[3] != std::array<double, 4>{0, 0, 0, 1})
    mesh.fail("placement", "the last row of 'placement' must be [0, 0, 0, 1]; divide the matrix by its last entry");
  Matrix34 matrix = Matrix34::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) matrix(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return matrix;
}

UpAxis read_up_axis(const TomlReader& mesh) {
  const std::string axis = mesh.text("up_axis");
  if (axis == "x") return UpAxis::x;
  if (axis == "y") return UpAxis::y;
  if (axis == "z") return UpAxis::z;
  mesh.fail("up_axis", "'up_axis' must be \"x\", \"y\" or \"z\"");
}

LengthRatio read_units(const TomlReader& mesh) {
  const std::string name = mesh.text("units");
  const auto* const unit = std::ranges::find_if(units, [&](const Unit& u) { return name == u.name; });
  if (unit == units.end()) mesh.fail("units", "'units' must be \"mm\", \"cm\", \"m\", \"in\" or \"ft\"");
  return unit->metres;
}

LengthRatio read_length(const TomlReader& mesh) {
  if (mesh.has("units") && mesh.has("scale"))
    mesh.fail("scale", "the mesh has both 'units' and 'scale'; give at most one");
  if (mesh.has("units")) return read_units(mesh);
  if (!mesh.has("scale")) return {};
  const double scale = mesh.number("scale");
  if (!(scale > 0)) mesh.fail("scale", "'scale' must be above 0; for a mirror image use 'placement'");
  return {scale, 1};
}

SceneMesh read_mesh_table(const TomlReader& mesh, const std::string& path, bool is_array) {
  mesh.allow_only({"file", "name", "sides", "placement", "up_axis", "units", "scale"});
  const std::string file = read_file_name(mesh);
  SceneMesh result;
  result.file = (std::filesystem::path(path).parent_path() / file).string();
  result.name = read_mesh_name(mesh, file, is_array);
  if (mesh.has("placement")) result.placement.matrix = read_placement(mesh);
  if (mesh.has("up_axis")) result.placement.up_axis = read_up_axis(mesh);
  result.placement.length = read_length(mesh);
  if (result.placement.orientation() == 0)
    mesh.fail("placement", "'placement' is singular: it flattens the mesh; give its first three columns rank 3");
  return result;
}

// Null where there is none.
const toml::table* optional_table(const toml::table& root, const std::string& path, const char* key) {
  const toml::node* node = root.get(key);
  if (node == nullptr) return nullptr;
  if (!node->is_table())
    throw InputError(path, node->source().begin.line, fmt::format("'{}' must be a table: [{}]", key, key));
  return node->as_table();
}

std::optional<RegionChoice> read_choice(const TomlReader& table, const char* key) {
  if (!table.has(key)) return std::nullopt;
  RegionChoice choice{key, table.texts(key), table.line(key)};
  if (choice.names.empty()) table.fail(key, fmt::format("'{}' is empty; name regions, or leave it out", key));
  return choice;
}

std::vector<int> read_illum(const TomlReader& table) {
  std::vector<int> models;
  for (const double model : table.numbers("illum")) {
    if (!(model >= 0 && model <= 1000 && model == std::floor(model)))
      table.fail("illum", "'illum' must be a list of integers: those that MTL files have");
    models.push_back(static_cast<int>(model));
  }
  if (models.empty()) table.fail("illum", "'illum' is empty; give a model, or leave it out");
  return models;
}

MaterialChoice read_material_choice(const TomlReader& table, std::size_t line) {
  table.allow_only({"illum", "Ks_min"});
  MaterialChoice choice{{}, table.optional_number("Ks_min"), line};
  if (table.has("illum")) choice.illum = read_illum(table);
  if (choice.illum.empty() && !choice.specular_min)
    table.fail("'mirrors_material' says nothing; give illum = [...], Ks_min = ..., or both");
  return choice;
}

}  // namespace

SceneMeshes read_meshes(const toml::table& root, const std::string& path) {
  const MeshTables found = mesh_tables(root, path);
  SceneMeshes result;
  bool has_sides = false;
  for (const TomlReader& table : found.tables) {
    result.meshes.push_back(read_mesh_table(table, path, found.is_array));
    const std::string& name = result.meshes.back().name;
    if (std::ranges::count(result.meshes, name, &SceneMesh::name) > 1)
      table.fail("name", fmt::format("a second mesh is called \"{}\"; give each another 'name'", name));
    if (!table.has("sides")) continue;
    if (has_sides) table.fail("sides", "'sides' is of the whole scene; give it once");
    has_sides = true;
    result.sides = read_sides(table);
  }
  return result;
}

SceneRegions read_regions(const toml::table& root, const std::string& path) {
  SceneRegions regions;
  if (const toml::table* table = optional_table(root, path, "regions")) {
    const TomlReader reader(*table, path, "[regions]", table->source().begin.line);
    reader.allow_only({"of_interest", "ignore"});
    regions.of_interest = read_choice(reader, "of_interest");
    regions.ignore = read_choice(reader, "ignore");
  }
  if (const toml::table* table = optional_table(root, path, "reflection")) {
    const TomlReader reader(*table, path, "[reflection]", table->source().begin.line);
    regions.mirrors = read_choice(reader, "mirrors");
    if (reader.has("mirrors_material"))
      regions.mirrors_material =
          read_material_choice(reader.table("mirrors_material"), reader.line("mirrors_material"));
  }
  return regions;
}

}  // namespace sightline::cli
