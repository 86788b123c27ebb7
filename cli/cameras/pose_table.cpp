#include "cli/cameras/pose_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "cli/cameras/document.h"
#include "cli/cameras/rotations.h"
#include "cli/cameras/text_lines.h"
#include "formats/reading/obj_scanner.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

constexpr std::array<std::string_view, 20> table_columns{
    "name", "eye_x", "eye_y", "eye_z", "target_x", "target_y", "target_z", "up_x",      "up_y",      "up_z",
    "tx",   "ty",    "tz",    "qw",    "qx",       "qy",       "qz",       "fov_y_deg", "fov_x_deg", "aspect"};

// Returns the fields of a line; one in quotes may have commas, and "" for a quote.
std::vector<std::string> table_fields(std::string_view line, const std::string& file, std::size_t number) {
  std::vector<std::string> fields;
  for (bool more = true; more;) {
    std::string field;
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.starts_with('"')) {
      for (;;) {
        const std::size_t end = line.find('"', 1);
        if (end == std::string_view::npos) throw InputError(file, number, "a quotation mark is not closed; close it");
        field += line.substr(1, end - 1);
        line.remove_prefix(end);
        if (!line.substr(1).starts_with('"')) break;
        field += '"';
        line.remove_prefix(1);
      }
      line.remove_prefix(1);
      if (!without_blanks_around(line.substr(0, line.find(','))).empty())
        throw InputError(file, number, "something stands behind a closed quotation mark; write \"\" for one in a name");
    } else {
      field = without_blanks_around(line.substr(0, line.find(',')));
    }
    const std::size_t comma = line.find(',');
    more = comma != std::string_view::npos;
    line.remove_prefix(more ? comma + 1 : line.size());
    fields.push_back(std::move(field));
  }
  return fields;
}

class PoseTableReader {
 public:
  PoseTableReader(const std::string& file, const CameraRequest& request, std::string_view head, std::size_t line)
      : file_(&file), request_(&request), head_line_(line) {
    const std::vector<std::string> names = table_fields(head, file, line);
    columns_ = names.size();
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (std::ranges::find(table_columns, names[i]) == table_columns.end() || names[i].empty()) {
        fail_head(fmt::format("unknown column '{}'; write one of: {}", printable(names[i]),
                              "name, eye_x, eye_y, eye_z, target_x, target_y, target_z, up_x, up_y, up_z, "
                              "tx, ty, tz, qw, qx, qy, qz, fov_y_deg, fov_x_deg, aspect"));
      }
      if (!column_.emplace(names[i], i).second) fail_head(fmt::format("a second column {}; remove it", names[i]));
    }
    check_head();
  }

  [[nodiscard]] CameraRecord camera(std::string_view line, std::size_t number) const {
    const std::vector<std::string> fields = table_fields(line, *file_, number);
    if (fields.size() != columns_) {
      throw InputError(*file_, number,
                       fmt::format("{} fields, and the first line has {}; write as many", fields.size(), columns_));
    }
    const Row row{&fields, number};
    CameraRecord record;
    if (has("name")) record.name = fields[column_.at("name")];
    record.line = number;
    if (has("tx")) {
      record.place = pose(row);
    } else {
      record.place = view(row);
    }
    if (const auto shape = window(row)) record.image = *shape;
    return record;
  }

  [[nodiscard]] bool has(std::string_view column) const { return column_.contains(column); }

 private:
  struct Row {
    const std::vector<std::string>* fields;
    std::size_t number;
  };

  [[noreturn]] void fail_head(const std::string& cause) const { throw InputError(*file_, head_line_, cause); }

  void require_all(std::initializer_list<std::string_view> columns) const {
    for (const std::string_view column : columns) {
      if (!has(column)) fail_head(fmt::format("there is no column {}; add it", column));
    }
  }

  void check_head() const {
    const bool by_quaternion = has("tx") || has("qw");
    if (by_quaternion && has("eye_x")) fail_head("there are eye_x and tx; give one form");
    if (by_quaternion) {
      require_all({"tx", "ty", "tz", "qw", "qx", "qy", "qz"});
      if (!request_->direction || !request_->axes) {
        fail_head(
            "quaternions can mean several things; say in [[cameras]] what they mean, with "
            "pose = \"camera_to_world\" or \"world_to_camera\", and axes = \"opencv\" or \"opengl\"");
      }
    } else {
      require_all({"eye_x", "eye_y", "eye_z", "target_x", "target_y", "target_z"});
    }
    if (has("up_x") || has("up_y") || has("up_z")) require_all({"up_x", "up_y", "up_z"});
    if (has("fov_x_deg") && has("fov_y_deg")) fail_head("there are fov_x_deg and fov_y_deg; give one");
    if (has("aspect") && !has("fov_x_deg")) require_all({"fov_y_deg"});
  }

  [[nodiscard]] double number(const Row& row, std::string_view column) const {
    const std::string& field = (*row.fields)[column_.find(column)->second];
    return parsed_number(field, *file_, row.number, column);
  }
  [[nodiscard]] Vector3 vector(const Row& row, std::string_view x, std::string_view y, std::string_view z) const {
    const double first = number(row, x);
    const double second = number(row, y);
    return {first, second, number(row, z)};
  }

  [[nodiscard]] ViewPoint view(const Row& row) const {
    ViewPoint view;
    view.eye = vector(row, "eye_x", "eye_y", "eye_z");
    view.target = vector(row, "target_x", "target_y", "target_z");
    if (has("up_x")) view.up = vector(row, "up_x", "up_y", "up_z");
    return view;
  }

  [[nodiscard]] std::variant<std::monostate, WorldToCamera, CameraPose, ViewPoint> pose(const Row& row) const {
    const Vector3 t = vector(row, "tx", "ty", "tz");
    const Vector3 q = vector(row, "qx", "qy", "qz");
    const double w = number(row, "qw");
    if (w == 0 && q == Vector3::Zero())
      throw InputError(*file_, row.number, "the quaternion is zero, which is no rotation; correct it");
    const Matrix3 r = rotation_of_quaternion({w, q.x(), q.y(), q.z()});
    if (request_->direction == PoseDirection::camera_to_world) {
      Matrix34 camera_to_world;
      camera_to_world << r, t;
      return camera_pose(camera_to_world, *request_->axes);
    }
    WorldToCamera pose{r, t};
    if (request_->axes == CameraAxes::opengl) {
      for (const int i : {1, 2}) {
        pose.r.row(i) = -pose.r.row(i);
        pose.t[i] = -pose.t[i];
      }
    }
    return pose;
  }

  [[nodiscard]] std::optional<WindowShape> window(const Row& row) const {
    if (!has("fov_x_deg") && !has("fov_y_deg")) return std::nullopt;
    WindowShape shape;
    if (has("aspect")) shape.aspect = number(row, "aspect");
    const std::string_view column = has("fov_y_deg") ? "fov_y_deg" : "fov_x_deg";
    const double angle = number(row, column);
    if (!(angle > 0 && angle < 180))
      throw InputError(*file_, row.number, fmt::format("'{}' must be between 0 and 180 degrees", column));
    shape.half_height = column == "fov_y_deg" ? tangent_of_half(angle) : tangent_of_half(angle) / shape.aspect;
    return shape;
  }

  const std::string* file_;
  const CameraRequest* request_;
  std::size_t head_line_;
  std::size_t columns_ = 0;
  std::map<std::string, std::size_t, std::less<>> column_;
};

bool is_passed_over(std::string_view line) {
  const std::string_view text = without_blanks_around(line);
  return text.empty() || text.starts_with('#');
}

}  // namespace

std::vector<CameraRecord> read_pose_table(std::string_view text, const std::string& file,
                                          const CameraRequest& request) {
  TextLines lines(text);
  auto line = lines.next();
  while (line && is_passed_over(*line)) line = lines.next();
  if (!line) throw InputError(file, 0, "the table is empty; name the columns in its first line");
  const PoseTableReader reader(file, request, *line, lines.number());
  std::vector<CameraRecord> records;
  for (line = lines.next(); line; line = lines.next()) {
    if (!is_passed_over(*line)) records.push_back(reader.camera(*line, lines.number()));
  }
  if (records.empty()) throw InputError(file, 0, "the table has no camera; add a line for each");
  if (reader.has("name")) return records;
  for (std::size_t i = 0; i < records.size(); ++i) records[i].name = numbered("camera", i, records.size());
  return records;
}

}  // namespace sightline::cli
