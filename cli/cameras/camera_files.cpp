#include "cli/cameras/camera_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/cameras/colmap_files.h"
#include "cli/cameras/document.h"
#include "cli/cameras/opencv_file.h"
#include "cli/cameras/pose_table.h"
#include "cli/cameras/text_lines.h"
#include "cli/cameras/transforms_file.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

enum class CameraFormat { json, xml, yaml, colmap_cameras, colmap_images, table, unknown };

bool is_word(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

bool is_whole_number(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

// Of the first line that is neither empty nor a comment.
CameraFormat format_of_line(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  if (is_word(line.substr(0, line.find(':'))) && line.find(':') != std::string_view::npos) return CameraFormat::yaml;
  if (line.find(',') != std::string_view::npos && is_word(without_blanks_around(line.substr(0, line.find(',')))))
    return CameraFormat::table;
  if (words.size() < 2 || !is_whole_number(words[0])) return CameraFormat::unknown;
  return words[1][0] >= 'A' && words[1][0] <= 'Z' ? CameraFormat::colmap_cameras : CameraFormat::colmap_images;
}

CameraFormat camera_format(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.starts_with("%YAML")) return CameraFormat::yaml;
  TextLines lines(text);
  for (auto line = lines.next(); line; line = lines.next()) {
    const std::string_view content = without_blanks_around(*line);
    if (content.empty() || content.starts_with('#')) continue;
    if (content.starts_with('{')) return CameraFormat::json;
    if (content.starts_with('<')) return CameraFormat::xml;
    if (content.starts_with("---")) return CameraFormat::yaml;
    return format_of_line(content);
  }
  return CameraFormat::unknown;
}

[[noreturn]] void refuse_format(std::string_view text, const std::string& file) {
  if (text.find('\0') != std::string_view::npos) {
    throw InputError(file, 0,
                     "a binary file, which has no cameras that are read; write it as text, a COLMAP model with colmap "
                     "model_converter --output_type TXT");
  }
  throw InputError(file, 0,
                   "no file of cameras that is known; give OpenCV's YAML, XML or JSON, COLMAP's images.txt, a "
                   "transforms.json, or CSV whose first line names the columns");
}

std::vector<CameraRecord> records_of_colmap(const ColmapCameras& cameras) {
  std::vector<CameraRecord> records;
  for (const auto& [id, camera] : cameras) {
    CameraRecord record;
    record.name = fmt::format("camera-{}", id);
    record.line = camera.line;
    record.image = camera.calibration;
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<CameraRecord> images_of_colmap(std::string_view text, const CameraRequest& request,
                                           const FileSource& files) {
  const std::string cameras_file =
      request.intrinsics.value_or((std::filesystem::path(request.file).parent_path() / "cameras.txt").string());
  const std::string cameras = files(cameras_file);
  if (camera_format(cameras) != CameraFormat::colmap_cameras)
    throw InputError(cameras_file, 0, "no cameras.txt of COLMAP; name that with intrinsics = \"FILE\"");
  return read_colmap_images(text, request.file, read_colmap_cameras(cameras, cameras_file, request), cameras_file);
}

std::vector<CameraRecord> records_in(std::string_view text, const std::string& file, const CameraRequest& request) {
  switch (camera_format(text)) {
    case CameraFormat::json: {
      const DocumentNode root = parse_json(text, file);
      return root.find("frames") != nullptr ? read_transforms(root, file, request) : read_opencv(root, file, request);
    }
    case CameraFormat::xml:
      return read_opencv(parse_xml(text, file), file, request);
    case CameraFormat::yaml:
      return read_opencv(parse_yaml(text, file), file, request);
    case CameraFormat::colmap_cameras:
      return records_of_colmap(read_colmap_cameras(text, file, request));
    case CameraFormat::table:
      return read_pose_table(text, file, request);
    case CameraFormat::colmap_images:
      throw InputError(file, 0, "COLMAP's images.txt has no intrinsics; name cameras.txt");
    case CameraFormat::unknown:
      break;
  }
  refuse_format(text, file);
}

// The only calibration of a file; views of one camera have the same one.
Calibration calibration_in(const std::string& file, const CameraRequest& request, const FileSource& files) {
  const std::vector<CameraRecord> records = records_in(files(file), file, request);
  const auto* calibration = std::get_if<Calibration>(&records.front().image);
  if (calibration == nullptr) throw InputError(file, 0, "there is no calibration in it; name a file that has one");
  for (const CameraRecord& record : records) {
    const auto* other = std::get_if<Calibration>(&record.image);
    if (other == nullptr || other->k != calibration->k) {
      throw InputError(file, record.line,
                       "there are several calibrations in it; name a file with one, for the poses of one camera");
    }
  }
  return *calibration;
}

void add_image(std::vector<CameraRecord>& records, const CameraRequest& request, const FileSource& files) {
  const auto lacks_image = [](const CameraRecord& r) { return std::holds_alternative<std::monostate>(r.image); };
  if (request.intrinsics) {
    if (!std::ranges::all_of(records, lacks_image))
      throw InputError(request.file, records.front().line,
                       "the file has intrinsics of its own; leave out `intrinsics`");
    const Calibration calibration = calibration_in(*request.intrinsics, request, files);
    for (CameraRecord& record : records) record.image = calibration;
  }
  if (!request.window) return;
  for (CameraRecord& record : records) {
    if (!lacks_image(record))
      throw InputError(request.file, record.line, "the file has intrinsics of its own; leave out the field of view");
    record.image = *request.window;
  }
}

void add_place(std::vector<CameraRecord>& records, const CameraRequest& request) {
  if (!request.place) return;
  for (CameraRecord& record : records) {
    if (!std::holds_alternative<std::monostate>(record.place))
      throw InputError(request.file, record.line, "the file has poses of its own; leave out R and t");
    record.place = *request.place;
  }
}

}  // namespace

std::array<double, 2> image_size(const std::array<double, 2>& in_file, const CameraRequest& request,
                                 const std::string& file, std::size_t line) {
  const bool is_said = in_file[0] != 0 || in_file[1] != 0;
  if (is_said && !(in_file[0] > 0 && in_file[1] > 0))
    throw InputError(file, line, "the width and height of the image must be positive; correct them");
  if (is_said && request.size && *request.size != in_file) {
    throw InputError(file, line,
                     fmt::format("the image is {} x {} here, and {} x {} in the scene file; leave out one of them",
                                 in_file[0], in_file[1], (*request.size)[0], (*request.size)[1]));
  }
  return is_said ? in_file : request.size.value_or(in_file);
}

std::vector<CameraRecord> read_camera_file(const CameraRequest& request, const FileSource& files) {
  const std::string text = files(request.file);
  if (camera_format(text) == CameraFormat::colmap_images) return images_of_colmap(text, request, files);
  std::vector<CameraRecord> records = records_in(text, request.file, request);
  add_image(records, request, files);
  add_place(records, request);
  return records;
}

}  // namespace sightline::cli
