#include "cli/scene/scene_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/scene/result_names.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

// The key that makes a camera one of the four forms.
std::string_view form_of(const TomlReader& table) {
  std::vector<std::string_view> found;
  for (const std::string_view key : {"fov_y_deg", "orthographic_height", "P", "K"}) {
    if (table.has(key)) found.push_back(key);
  }
  if (found.empty()) table.fail("the camera has none of fov_y_deg, orthographic_height, P, K; give exactly one");
  if (found.size() > 1) {
    table.fail(found[1], fmt::format("the camera has both '{}' and '{}'; give exactly one", found[0], found[1]));
  }
  return found[0];
}

std::string read_camera_name(const TomlReader& table) {
  const std::string name = table.text("name");
  const auto defect = name_defect(name);
  if (defect) table.fail("name", "the camera's name " + *defect + "; it becomes the name of a folder");
  if (is_file_beside_folders(name))
    table.fail("name", "the camera's name is that of a file beside the cameras' folders");
  return name;
}

ViewPoint read_view_point(const TomlReader& table) {
  ViewPoint view;
  view.eye = table.vector("eye");
  view.target = table.vector("target");
  if (table.has("up")) view.up = table.vector("up");
  view.aspect = table.optional_number("aspect").value_or(1);
  view.near_distance = table.optional_number("near");
  view.far_distance = table.optional_number("far");
  return view;
}

PixelOrigin read_pixel_origin(const TomlReader& table) {
  if (!table.has("pixel_origin")) return PixelOrigin::corner;
  const std::string origin = table.text("pixel_origin");
  if (origin != "corner" && origin != "center")
    table.fail("pixel_origin", "'pixel_origin' must be \"corner\" or \"center\"");
  return origin == "center" ? PixelOrigin::center : PixelOrigin::corner;
}

PixelImage read_image(const TomlReader& table) {
  const auto [width, height] = table.pair("image");
  return {width, height, read_pixel_origin(table), table.optional_number("near"), table.optional_number("far")};
}

// One value after the other, not as arguments of one call: which of several errors is reported must not depend on
// the compiler's order of evaluation.
Camera read_pinhole(const TomlReader& table) {
  table.allow_only({"name", "eye", "target", "up", "fov_y_deg", "aspect", "near", "far"});
  const std::string name = read_camera_name(table);
  const ViewPoint view = read_view_point(table);
  return perspective_camera(name, view, table.number("fov_y_deg"));
}

Camera read_orthographic(const TomlReader& table) {
  table.allow_only({"name", "eye", "target", "up", "orthographic_height", "aspect", "near", "far"});
  const std::string name = read_camera_name(table);
  const ViewPoint view = read_view_point(table);
  return orthographic_camera(name, view, table.number("orthographic_height"));
}

Camera read_matrix(const TomlReader& table) {
  table.allow_only({"name", "P", "image", "pixel_origin", "near", "far"});
  const std::string name = read_camera_name(table);
  const Matrix34 p = table.matrix<4>("P");
  return projection_matrix_camera(name, p, read_image(table));
}

Camera read_calibrated(const TomlReader& table) {
  table.allow_only({"name", "K", "R", "t", "image", "pixel_origin", "near", "far"});
  const std::string name = read_camera_name(table);
  const Matrix3 k = table.matrix<3>("K");
  const Matrix3 r = table.matrix<3>("R");
  const Vector3 t = table.vector("t");
  return calibrated_camera(name, k, r, t, read_image(table));
}

// A panel's name is a word in column names, group names and property names.
std::string read_panel_name(const TomlReader& table) {
  const std::string name = table.text("name");
  if (const auto defect = name_defect(name)) table.fail("name", "the panel's name " + *defect);
  const auto is_part_of_word = [](char c) { return c != ' ' && c != ',' && c != ';' && c != '#'; };
  if (!std::ranges::all_of(name, is_part_of_word))
    table.fail("name", "the panel's name has a space or one of , ; #; it becomes a part of column names");
  return name;
}

Emits read_emits(const TomlReader& table) {
  if (!table.has("emits")) return Emits::both;
  const std::string emits = table.text("emits");
  if (emits != "front" && emits != "both") table.fail("emits", "'emits' must be \"front\" or \"both\"");
  return emits == "front" ? Emits::front : Emits::both;
}

ReflectionMode read_mode(const TomlReader& table) {
  if (!table.has("mode")) return ReflectionMode::exact;
  const std::string word = table.text("mode");
  for (const ReflectionMode mode : {ReflectionMode::exact, ReflectionMode::triangles, ReflectionMode::smooth}) {
    if (word == to_string(mode)) return mode;
  }
  table.fail("mode", "'mode' must be \"exact\", \"triangles\" or \"smooth\"");
}

MirrorNormals read_normals(const TomlReader& table) {
  const std::string word = table.text("normals");
  for (const MirrorNormals normals : {MirrorNormals::face, MirrorNormals::vertex}) {
    if (word == to_string(normals)) return normals;
  }
  table.fail("normals", "'normals' must be \"face\" or \"vertex\"");
}

double read_tolerance(const TomlReader& table) {
  const double tolerance = table.number("tolerance");
  if (!(tolerance > 0 && tolerance < 1)) table.fail("tolerance", "'tolerance' must be between 0 and 1");
  return tolerance;
}

NormalMeans read_means(const TomlReader& table) {
  const std::string word = table.text("means");
  for (const NormalMeans means : {NormalMeans::area, NormalMeans::plain}) {
    if (word == to_string(means)) return means;
  }
  table.fail("means", "'means' must be \"area\" or \"plain\"");
}

double read_crease_angle(const TomlReader& table) {
  const double angle = table.number("crease_angle_deg");
  if (!(angle >= 0 && angle <= 180)) table.fail("crease_angle_deg", "'crease_angle_deg' must be from 0 to 180");
  return angle;
}

}  // namespace

Camera read_camera(const TomlReader& table) {
  table.allow_only({"name", "eye", "target", "up", "fov_y_deg", "orthographic_height", "aspect", "P", "K", "R", "t",
                    "image", "pixel_origin", "near", "far"});
  const std::string_view form = form_of(table);
  try {
    if (form == "fov_y_deg") return read_pinhole(table);
    if (form == "orthographic_height") return read_orthographic(table);
    if (form == "P") return read_matrix(table);
    return read_calibrated(table);
  } catch (const CameraError& error) {
    table.fail(error.what());
  }
}

Panel read_panel(const TomlReader& table) {
  table.allow_only({"name", "corners", "emits"});
  Panel panel{read_panel_name(table), table.points("corners"), read_emits(table)};
  try {
    static_cast<void>(panel_mesh(panel));
  } catch (const PanelError& error) {
    table.fail("corners", error.what());
  }
  return panel;
}

ReflectionOptions read_reflection(const TomlReader& table) {
  table.allow_only({"mode", "normals", "tolerance", "means", "crease_angle_deg", "mirrors", "mirrors_material"});
  ReflectionOptions options;
  options.mode = read_mode(table);
  const auto only_for = [&](const char* key, ReflectionMode mode) {
    if (!table.has(key)) return false;
    if (options.mode != mode) table.fail(key, fmt::format("'{}' is for mode \"{}\" only", key, to_string(mode)));
    return true;
  };
  if (only_for("normals", ReflectionMode::triangles)) options.normals = read_normals(table);
  if (only_for("tolerance", ReflectionMode::smooth)) options.tolerance = read_tolerance(table);
  for (const char* key : {"means", "crease_angle_deg"}) {
    if (table.has(key) && !options.needs_vertex_normals())
      table.fail(key, fmt::format("'{}' is for modes that have vertex normals: \"smooth\" and \"triangles\"", key));
  }
  if (table.has("means")) options.means = read_means(table);
  if (table.has("crease_angle_deg")) options.crease_angle_degrees = read_crease_angle(table);
  return options;
}

}  // namespace sightline::cli
