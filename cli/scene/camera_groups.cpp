#include "cli/scene/camera_groups.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "cli/cameras/camera_files.h"
#include "cli/cameras/camera_rigs.h"
#include "cli/scene/camera_names.h"
#include "cli/scene/camera_tables.h"
#include "cli/scene/result_names.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

// Returns which of the keys the group has; none where there is none.
std::string_view only_key_of(const TomlReader& table, std::initializer_list<std::string_view> keys) {
  std::string_view found;
  for (const std::string_view key : keys) {
    if (!table.has(key)) continue;
    if (!found.empty())
      table.fail(key, fmt::format("the group of cameras has both '{}' and '{}'; give one", found, key));
    found = key;
  }
  return found;
}

std::string group_name(const TomlReader& table, const std::string& name) {
  const std::string whole = (table.has("prefix") ? table.text("prefix") : "") + name;
  if (const auto defect = name_defect(whole))
    table.fail("prefix", fmt::format("'{}', a camera's name behind the prefix, {}; set another prefix",
                                     printable(whole), *defect));
  return whole;
}

ViewLimits read_limits(const TomlReader& table) {
  return {table.optional_number("near"), table.optional_number("far"),
          table.optional_number("frame_tolerance").value_or(default_frame_tolerance)};
}

std::string read_path(const TomlReader& table, std::string_view key, const std::string& scene_file) {
  const std::string name = table.text(key);
  if (name.find('\0') != std::string::npos)
    table.fail(key, fmt::format("'{}' has a NUL character, and no file is called so; remove it", key));
  return (std::filesystem::path(scene_file).parent_path() / name).string();
}

template <class Value>
std::optional<Value> read_word(const TomlReader& table, const char* key,
                               std::initializer_list<std::pair<std::string_view, Value>> words) {
  if (!table.has(key)) return std::nullopt;
  const std::string word = table.text(key);
  std::string known;
  for (const auto& [name, value] : words) {
    if (word == name) return value;
    known += fmt::format("{}\"{}\"", known.empty() ? "" : " or ", name);
  }
  table.fail(key, fmt::format("'{}' must be {}", key, known));
}

std::optional<WorldToCamera> read_place(const TomlReader& table) {
  if (!table.has("R") && !table.has("t")) return std::nullopt;
  WorldToCamera place;
  place.r = table.matrix<3>("R");
  place.t = table.vector("t");
  return place;
}

std::optional<WindowShape> read_window_shape(const TomlReader& table) {
  const std::string_view form = only_key_of(table, {"fov_y_deg", "fov_x_deg", "focal_length_mm"});
  if (form.empty()) {
    for (const char* key : {"aspect", "sensor_mm"}) {
      if (table.has(key)) table.fail(key, fmt::format("'{}' goes with a field of view; give that, too", key));
    }
    return std::nullopt;
  }
  const WindowKeys window = read_window(table, form);
  return WindowShape{window.height, window.aspect};
}

CameraRequest read_request(const TomlReader& table, const std::string& scene_file) {
  CameraRequest request;
  request.file = read_path(table, "file", scene_file);
  if (table.has("intrinsics")) request.intrinsics = read_path(table, "intrinsics", scene_file);
  if (table.has("image")) request.size = table.pair("image");
  if (request.size && !((*request.size)[0] > 0 && (*request.size)[1] > 0))
    table.fail("image", "'image' must be two positive numbers");
  request.origin = read_pixel_origin(table);
  request.lens_model =
      read_word<LensModel>(table, "lens_model", {{"brown", LensModel::brown}, {"fisheye", LensModel::fisheye}});
  request.direction = read_word<PoseDirection>(
      table, "pose",
      {{"camera_to_world", PoseDirection::camera_to_world}, {"world_to_camera", PoseDirection::world_to_camera}});
  request.axes = read_axes(table);
  request.window = read_window_shape(table);
  request.place = read_place(table);
  return request;
}

// Returns the records that are asked for, in file order, each with a name for a folder.
std::vector<CameraRecord> chosen_records(const TomlReader& table, std::vector<CameraRecord> records) {
  DistinctNames names;
  for (CameraRecord& record : records) record.name = names.next(folder_name(record.name));
  std::vector<CameraRecord> chosen;
  if (table.has("every")) {
    if (table.has("select")) table.fail("every", "there are 'select' and 'every'; give one");
    const std::size_t step = table.count("every", most_group_cameras);
    for (std::size_t i = 0; i < records.size(); i += step) chosen.push_back(records[i]);
    return chosen;
  }
  if (!table.has("select")) return records;
  const std::vector<std::string> listed = table.texts("select");
  if (listed.empty()) table.fail("select", "'select' chooses no camera; leave it out for all of them");
  std::set<std::string> wanted(listed.begin(), listed.end());
  for (const CameraRecord& record : records) {
    if (wanted.erase(record.name) > 0) chosen.push_back(record);
  }
  if (!wanted.empty()) {
    table.fail("select", fmt::format("the file has no camera '{}'; its first one is '{}'; choose from its own",
                                     printable(*wanted.begin()), printable(records.front().name)));
  }
  return chosen;
}

std::vector<Camera> read_file_group(const TomlReader& table, const std::string& scene_file, const FileSource& files) {
  table.allow_only({"file",      "intrinsics",   "prefix",     "select",    "every",
                    "image",     "pixel_origin", "lens_model", "R",         "t",
                    "pose",      "axes",         "fov_y_deg",  "fov_x_deg", "focal_length_mm",
                    "sensor_mm", "aspect",       "near",       "far",       "frame_tolerance"});
  const CameraRequest request = read_request(table, scene_file);
  const ViewLimits limits = read_limits(table);
  const std::vector<CameraRecord> records = chosen_records(table, read_camera_file(request, files));
  if (records.size() > most_group_cameras)
    table.fail("file", fmt::format("more than {} cameras; choose with 'every' or 'select'", most_group_cameras));
  std::vector<Camera> cameras;
  for (const CameraRecord& record : records) {
    const std::string name = group_name(table, record.name);
    try {
      cameras.push_back(camera_of(record, name, limits));
    } catch (const CameraError& error) {
      throw InputError(request.file, record.line, error.what());
    }
  }
  if (table.has("frame_tolerance") &&
      std::ranges::none_of(cameras, [](const Camera& c) { return c.lens_image.has_value(); }))
    table.fail("frame_tolerance",
               "no camera of the group has a lens, and 'frame_tolerance' is for these; leave it out");
  return cameras;
}

double read_radius(const TomlReader& rig) {
  const double radius = rig.number("radius");
  if (!(radius > 0)) rig.fail("radius", "'radius' must be positive");
  return radius;
}

Ring read_ring(const TomlReader& rig) {
  rig.allow_only({"number", "center", "radius", "height", "axis", "start"});
  Ring ring;
  ring.number = rig.count("number", most_group_cameras);
  if (rig.has("center")) ring.center = rig.vector("center");
  ring.radius = read_radius(rig);
  ring.height = rig.optional_number("height").value_or(0);
  if (rig.has("axis")) ring.axis = rig.vector("axis");
  if (rig.has("start")) ring.start = rig.vector("start");
  return ring;
}

Sphere read_sphere(const TomlReader& rig) {
  rig.allow_only({"number", "center", "radius", "axis"});
  Sphere sphere;
  sphere.number = rig.count("number", most_group_cameras);
  if (rig.has("center")) sphere.center = rig.vector("center");
  sphere.radius = read_radius(rig);
  if (rig.has("axis")) sphere.axis = rig.vector("axis");
  return sphere;
}

Grid read_grid(const TomlReader& rig) {
  rig.allow_only({"number", "size", "center", "target", "up"});
  Grid grid;
  const std::vector<std::size_t> number = rig.counts("number", most_group_cameras);
  if (number.size() != 2) rig.fail("number", "'number' must be [columns, rows]");
  if (number[0] * number[1] > most_group_cameras)
    rig.fail("number", fmt::format("more than {} cameras; write fewer", most_group_cameras));
  grid.columns = number[0];
  grid.rows = number[1];
  grid.size = rig.pair("size");
  grid.center = rig.vector("center");
  grid.target = rig.vector("target");
  if (rig.has("up")) grid.up = rig.vector("up");
  return grid;
}

std::vector<RigCamera> rig_cameras(const TomlReader& table, std::string_view kind) {
  const TomlReader rig = table.table(kind);
  if (kind == "ring") return cameras_of(read_ring(rig));
  if (kind == "sphere") return cameras_of(read_sphere(rig));
  return cameras_of(read_grid(rig));
}

std::vector<Camera> read_rig_group(const TomlReader& table, std::string_view kind) {
  table.allow_only({kind, "prefix", "fov_y_deg", "fov_x_deg", "focal_length_mm", "sensor_mm", "orthographic_height",
                    "aspect", "shift", "near", "far"});
  const std::string_view form =
      only_key_of(table, {"fov_y_deg", "fov_x_deg", "focal_length_mm", "orthographic_height"});
  if (form.empty())
    table.fail("the cameras have none of fov_y_deg, fov_x_deg, focal_length_mm, orthographic_height; give one");
  const WindowKeys window = read_window(table, form);
  const ViewLimits limits = read_limits(table);
  std::vector<Camera> cameras;
  for (auto& [name, view] : rig_cameras(table, kind)) {
    view.near_distance = limits.near_distance;
    view.far_distance = limits.far_distance;
    cameras.push_back(window_camera(group_name(table, name), view, window));
  }
  return cameras;
}

}  // namespace

std::vector<Camera> read_camera_group(const TomlReader& table, const std::string& scene_file, const FileSource& files) {
  const std::string_view kind = only_key_of(table, {"file", "ring", "sphere", "grid"});
  if (kind.empty()) table.fail("the group of cameras has none of file, ring, sphere, grid; give one");
  if (kind == "file") return read_file_group(table, scene_file, files);
  try {
    return read_rig_group(table, kind);
  } catch (const CameraError& error) {
    table.fail(error.what());
  }
}

}  // namespace sightline::cli
