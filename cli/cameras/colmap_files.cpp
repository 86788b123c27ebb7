#include "cli/cameras/colmap_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/cameras/document.h"
#include "cli/cameras/rotations.h"
#include "cli/cameras/text_lines.h"
#include "formats/reading/obj_scanner.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

// What the parameters of a model are: one focal length or two, the centre, and coefficients of a lens in this order.
struct ColmapModel {
  std::string_view name;
  std::size_t focal_lengths;
  std::optional<LensModel> lens;
  std::vector<int> coefficients;  // 0 to 5: k1 to k6, or w; -1 and -2: p1 and p2; -3 and -4: s1 and s2
};

const std::vector<ColmapModel>& colmap_models() {
  static const std::vector<ColmapModel> models{
      {"SIMPLE_PINHOLE", 1, std::nullopt, {}},
      {"PINHOLE", 2, std::nullopt, {}},
      {"SIMPLE_RADIAL", 1, LensModel::brown, {0}},
      {"RADIAL", 1, LensModel::brown, {0, 1}},
      {"OPENCV", 2, LensModel::brown, {0, 1, -1, -2}},
      {"FULL_OPENCV", 2, LensModel::brown, {0, 1, -1, -2, 2, 3, 4, 5}},
      {"OPENCV_FISHEYE", 2, LensModel::fisheye, {0, 1, 2, 3}},
      {"SIMPLE_RADIAL_FISHEYE", 1, LensModel::fisheye, {0}},
      {"RADIAL_FISHEYE", 1, LensModel::fisheye, {0, 1}},
      {"THIN_PRISM_FISHEYE", 2, LensModel::fisheye, {0, 1, -1, -2, 2, 3, -3, -4}},
      {"FOV", 2, LensModel::field_of_view, {0}},
  };
  return models;
}

const ColmapModel& colmap_model(std::string_view name, const std::string& file, std::size_t line) {
  const auto found = std::ranges::find(colmap_models(), name, &ColmapModel::name);
  if (found != colmap_models().end()) return *found;
  throw InputError(file, line,
                   fmt::format("the camera model {} is not read; undistort the images with COLMAP (colmap "
                               "image_undistorter), and take the files of these",
                               quoted(name)));
}

std::int64_t colmap_id(std::string_view word, const std::string& file, std::size_t line, const char* what) {
  const auto id = parse_integer(word);
  if (!id) throw InputError(file, line, fmt::format("{} is no {}; write a whole number", quoted(word), what));
  return *id;
}

double& coefficient_at(Lens& lens, int place) {
  if (place >= 0) return lens.radial[static_cast<std::size_t>(place)];
  return place >= -2 ? lens.tangential[static_cast<std::size_t>(-place - 1)]
                     : lens.prism[static_cast<std::size_t>(-place - 3)];
}

// A field of view of 0 is that of a pinhole; its sign does not matter.
Lens colmap_lens(const ColmapModel& model, const std::vector<double>& parameters, std::size_t first) {
  Lens lens;
  lens.model = *model.lens;
  for (std::size_t i = 0; i < model.coefficients.size(); ++i)
    coefficient_at(lens, model.coefficients[i]) = parameters[first + i];
  if (lens.model != LensModel::field_of_view) return lens;
  lens.radial[0] = std::fabs(lens.radial[0]);
  return lens.radial[0] > 0 ? lens : Lens{};
}

Calibration colmap_calibration(const std::vector<std::string_view>& words, const std::string& file, std::size_t line,
                               const CameraRequest& request) {
  const ColmapModel& model = colmap_model(words[1], file, line);
  std::vector<double> numbers;
  for (std::size_t i = 2; i < words.size(); ++i) numbers.push_back(parsed_number(words[i], file, line, words[1]));
  const std::size_t expected = 2 + model.focal_lengths + 2 + model.coefficients.size();
  if (numbers.size() != expected) {
    throw InputError(file, line,
                     fmt::format("{} has {} numbers, and here are {}; write CAMERA_ID MODEL WIDTH HEIGHT "
                                 "PARAMS...",
                                 model.name, expected, numbers.size()));
  }
  const double fx = numbers[2];
  const double fy = numbers[1 + model.focal_lengths];
  const std::size_t centre = 2 + model.focal_lengths;
  Calibration calibration;
  calibration.k << fx, 0, numbers[centre], 0, fy, numbers[centre + 1], 0, 0, 1;
  const auto [width, height] = image_size({numbers[0], numbers[1]}, request, file, line);
  calibration.width = width;
  calibration.height = height;
  calibration.origin = request.origin.value_or(PixelOrigin::corner);
  if (model.lens) calibration.lens = colmap_lens(model, numbers, centre + 2);
  return calibration;
}

bool is_comment(std::string_view line) {
  const std::string_view text = without_blanks_around(line);
  return text.empty() || text.starts_with('#');
}

CameraRecord colmap_image(std::string_view line, std::size_t number, const std::string& file,
                          const ColmapCameras& cameras, const std::string& cameras_file) {
  std::array<double, 8> values{};  // of them the first one is the image's id
  for (double& value : values) {
    const std::string_view word = take_word(line);
    if (word.empty())
      throw InputError(file, number, "an image has ten fields: IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME; add them");
    value = parsed_number(word, file, number, "image");
  }
  const std::int64_t id = colmap_id(take_word(line), file, number, "CAMERA_ID");
  const auto camera = cameras.find(id);
  if (camera == cameras.end())
    throw InputError(file, number,
                     fmt::format("there is no camera {} in {}; add it there", id, printable(cameras_file)));
  if (values[1] == 0 && values[2] == 0 && values[3] == 0 && values[4] == 0)
    throw InputError(file, number, "the quaternion QW QX QY QZ is zero, which is no rotation; correct it");
  CameraRecord record;
  record.name = without_blanks_around(line);
  record.line = number;
  record.image = camera->second.calibration;
  record.place = WorldToCamera{rotation_of_quaternion({values[1], values[2], values[3], values[4]}),
                               {values[5], values[6], values[7]}};
  return record;
}

}  // namespace

ColmapCameras read_colmap_cameras(std::string_view text, const std::string& file, const CameraRequest& request) {
  ColmapCameras cameras;
  TextLines lines(text);
  for (auto line = lines.next(); line; line = lines.next()) {
    if (is_comment(*line)) continue;
    const std::vector<std::string_view> words = words_of(*line);
    if (words.size() < 4)
      throw InputError(file, lines.number(), "a camera is CAMERA_ID MODEL WIDTH HEIGHT PARAMS...; add what is missing");
    const std::int64_t id = colmap_id(words[0], file, lines.number(), "CAMERA_ID");
    const ColmapCamera camera{colmap_calibration(words, file, lines.number(), request), lines.number()};
    if (!cameras.emplace(id, camera).second)
      throw InputError(file, lines.number(), fmt::format("a second camera {}; remove one of them", id));
  }
  if (cameras.empty()) throw InputError(file, 0, "there is no camera in it; name COLMAP's cameras.txt");
  return cameras;
}

std::vector<CameraRecord> read_colmap_images(std::string_view text, const std::string& file,
                                             const ColmapCameras& cameras, const std::string& cameras_file) {
  std::vector<CameraRecord> records;
  TextLines lines(text);
  for (auto line = lines.next(); line; line = lines.next()) {
    if (is_comment(*line)) continue;
    records.push_back(colmap_image(*line, lines.number(), file, cameras, cameras_file));
    (void)lines.next();  // its points
  }
  if (records.empty()) throw InputError(file, 0, "there is no image in it; name COLMAP's images.txt");
  return records;
}

}  // namespace sightline::cli
