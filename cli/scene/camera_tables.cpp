#include "cli/scene/camera_tables.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cli/scene/lens_keys.h"
#include "cli/scene/result_names.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

// The key that makes a camera one of the forms.
std::string_view form_of(const TomlReader& table) {
  std::vector<std::string_view> found;
  for (const std::string_view key : {"fov_y_deg", "orthographic_height", "P", "K", "fov_x_deg", "focal_length_mm"}) {
    if (table.has(key)) found.push_back(key);
  }
  if (found.empty()) {
    table.fail(
        "the camera has none of fov_y_deg, orthographic_height, P, K, fov_x_deg, focal_length_mm; give exactly one");
  }
  if (found.size() > 1) {
    table.fail(found[1], fmt::format("the camera has both '{}' and '{}'; give exactly one", found[0], found[1]));
  }
  return found[0];
}

std::string read_camera_name(const TomlReader& table) {
  const std::string name = table.text("name");
  const auto defect = name_defect(name);
  if (defect)
    table.fail("name", "the camera's name " + *defect + ", and it becomes the name of a folder; choose another");
  if (is_file_beside_folders(name))
    table.fail("name", "the camera's name is that of a file beside the cameras' folders; choose another");
  return name;
}

// Three rows, and a fourth one that is 0, 0, 0, 1 or not there.
Matrix34 read_camera_to_world(const TomlReader& table) {
  const std::vector<std::vector<double>> rows = table.rows("camera_to_world");
  bool fits = rows.size() == 3 || rows.size() == 4;
  for (const auto& row : rows) fits = fits && row.size() == 4;
  if (!fits) table.fail("camera_to_world", "'camera_to_world' must have 3 or 4 rows of 4 numbers");
  if (rows.size() == 4 && rows[3] != std::vector<double>{0, 0, 0, 1})
    table.fail("camera_to_world", "the last row of 'camera_to_world' must be [0, 0, 0, 1]");
  Matrix34 matrix;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) matrix(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return matrix;
}

CameraPose read_camera_pose(const TomlReader& table) {
  const Matrix34 camera_to_world = read_camera_to_world(table);
  const auto axes = read_axes(table);
  if (!axes) {
    table.fail("camera_to_world",
               "'camera_to_world' needs axes; write axes = \"opengl\" (y up, the view along -z) or \"opencv\" (y down, "
               "along z)");
  }
  return camera_pose(camera_to_world, *axes);
}

void refuse_beside(const TomlReader& table, std::string_view key, std::initializer_list<std::string_view> others) {
  for (const std::string_view other : others) {
    if (table.has(other)) table.fail(other, fmt::format("the camera has both '{}' and '{}'; give one", key, other));
  }
}

ViewPoint read_view_point(const TomlReader& table, const std::string& name) {
  ViewPoint view;
  if (table.has("camera_to_world")) {
    refuse_beside(table, "camera_to_world", {"eye", "target", "up"});
    const CameraPose pose = read_camera_pose(table);
    require_rotation(name, pose.rotation);
    view.eye = pose.eye;
    view.direction = Vector3(pose.rotation.row(2));
    view.up = -pose.rotation.row(1);
  } else {
    if (table.has("axes")) table.fail("axes", "'axes' goes with 'camera_to_world'; leave it out");
    view.eye = table.vector("eye");
    view.target = table.vector("target");
    if (table.has("up")) view.up = table.vector("up");
  }
  view.near_distance = table.optional_number("near");
  view.far_distance = table.optional_number("far");
  return view;
}

ImageY read_image_y(const TomlReader& table) {
  if (!table.has("image_y")) return ImageY::down;
  const std::string direction = table.text("image_y");
  if (direction != "down" && direction != "up") table.fail("image_y", "'image_y' must be \"down\" or \"up\"");
  return direction == "up" ? ImageY::up : ImageY::down;
}

PixelImage read_image(const TomlReader& table) {
  const auto [width, height] = table.pair("image");
  PixelImage image{width, height, read_pixel_origin(table).value_or(PixelOrigin::corner)};
  image.y = read_image_y(table);
  image.near_distance = table.optional_number("near");
  image.far_distance = table.optional_number("far");
  return image;
}

double positive(const TomlReader& table, std::string_view key) {
  const double value = table.number(key);
  if (!(value > 0)) table.fail(key, fmt::format("'{}' must be positive", key));
  return value;
}

// Half the height of the window at distance 1 of what `form` says, and its aspect.
void read_focal_length(const TomlReader& table, WindowKeys& window) {
  if (table.has("aspect")) table.fail("aspect", "the aspect is that of 'sensor_mm'; leave out 'aspect'");
  const double focal_length = positive(table, "focal_length_mm");
  const auto [width, height] = table.pair("sensor_mm");
  if (!(width > 0 && height > 0)) table.fail("sensor_mm", "'sensor_mm' must be two positive numbers");
  window.height = height / (2 * focal_length);
  window.aspect = width / height;
}

double read_angle(const TomlReader& table, std::string_view key) {
  const double degrees = table.number(key);
  if (!(degrees > 0 && degrees < 180)) {
    table.fail(fmt::format("the {} field of view is not between 0 and 180 degrees; give an angle that is",
                           key == "fov_y_deg" ? "vertical" : "horizontal"));
  }
  return tangent_of_half(degrees);
}

// One value after the other, not as arguments of one call: which of several errors is reported must not depend on
// the compiler's order of evaluation.
Camera read_window_camera(const TomlReader& table, std::string_view form) {
  table.allow_only(
      {"name", "eye", "target", "up", "camera_to_world", "axes", form, "sensor_mm", "aspect", "shift", "near", "far"});
  const std::string name = read_camera_name(table);
  const ViewPoint view = read_view_point(table, name);
  return window_camera(name, view, read_window(table, form));
}

Camera read_matrix(const TomlReader& table) {
  table.allow_only({"name", "P", "image", "pixel_origin", "image_y", "near", "far"});
  const std::string name = read_camera_name(table);
  const Matrix34 p = table.matrix<4>("P");
  return projection_matrix_camera(name, p, read_image(table));
}

Camera read_calibrated(const TomlReader& table) {
  table.allow_only({"name", "K", "R", "t", "camera_to_world", "axes", "image", "pixel_origin", "image_y", "near", "far",
                    "distortion", "fisheye", "frame_tolerance"});
  const std::string name = read_camera_name(table);
  const Matrix3 k = table.matrix<3>("K");
  const LensKeys lens = read_lens(table);
  if (table.has("camera_to_world")) {
    refuse_beside(table, "camera_to_world", {"R", "t"});
    const CameraPose pose = read_camera_pose(table);
    return posed_camera(name, k, pose, read_image(table), lens.lens, lens.frame_tolerance);
  }
  if (table.has("axes")) table.fail("axes", "'axes' goes with 'camera_to_world'; leave it out");
  const Matrix3 r = table.matrix<3>("R");
  const Vector3 t = table.vector("t");
  return calibrated_camera(name, k, r, t, read_image(table), lens.lens, lens.frame_tolerance);
}

}  // namespace

std::optional<PixelOrigin> read_pixel_origin(const TomlReader& table) {
  if (!table.has("pixel_origin")) return std::nullopt;
  const std::string origin = table.text("pixel_origin");
  if (origin != "corner" && origin != "center")
    table.fail("pixel_origin", "'pixel_origin' must be \"corner\" or \"center\"");
  return origin == "center" ? PixelOrigin::center : PixelOrigin::corner;
}

std::optional<CameraAxes> read_axes(const TomlReader& table) {
  if (!table.has("axes")) return std::nullopt;
  const std::string axes = table.text("axes");
  if (axes != "opengl" && axes != "opencv") table.fail("axes", "'axes' must be \"opengl\" or \"opencv\"");
  return axes == "opengl" ? CameraAxes::opengl : CameraAxes::opencv;
}

WindowKeys read_window(const TomlReader& table, std::string_view form) {
  WindowKeys window;
  if (form != "focal_length_mm" && table.has("sensor_mm"))
    table.fail("sensor_mm", "'sensor_mm' goes with 'focal_length_mm'; leave it out");
  if (form == "focal_length_mm") {
    read_focal_length(table, window);
  } else {
    window.aspect = table.optional_number("aspect").value_or(1);
    if (!(window.aspect > 0)) table.fail("aspect is not a positive number; give one");
  }
  if (form == "fov_y_deg") window.height = read_angle(table, form);
  if (form == "fov_x_deg") window.height = read_angle(table, form) / window.aspect;
  if (form == "orthographic_height") {
    window.projection = Projection::orthographic;
    window.height = table.number(form);
  }
  if (table.has("shift")) window.shift = table.pair("shift");
  return window;
}

Camera window_camera(const std::string& name, ViewPoint view, const WindowKeys& window) {
  view.aspect = window.aspect;
  Camera camera = window.projection == Projection::perspective ? pinhole_camera(name, view, window.height)
                                                               : orthographic_camera(name, view, window.height);
  return window.shift == std::array<double, 2>{} ? camera : shifted(std::move(camera), window.shift);
}

Camera read_camera(const TomlReader& table) {
  table.allow_only({"name",
                    "eye",
                    "target",
                    "up",
                    "fov_y_deg",
                    "fov_x_deg",
                    "focal_length_mm",
                    "sensor_mm",
                    "shift",
                    "orthographic_height",
                    "aspect",
                    "P",
                    "K",
                    "R",
                    "t",
                    "camera_to_world",
                    "axes",
                    "image",
                    "pixel_origin",
                    "image_y",
                    "near",
                    "far",
                    "distortion",
                    "fisheye",
                    "frame_tolerance"});
  const std::string_view form = form_of(table);
  try {
    if (form == "P") return read_matrix(table);
    if (form == "K") return read_calibrated(table);
    return read_window_camera(table, form);
  } catch (const CameraError& error) {
    table.fail(error.what());
  }
}

}  // namespace sightline::cli
