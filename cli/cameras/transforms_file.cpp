#include "cli/cameras/transforms_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

class TransformsReader {
 public:
  TransformsReader(const DocumentNode& root, const std::string& file, const CameraRequest& request)
      : root_(&root), file_(&file), request_(&request) {}

  [[nodiscard]] std::vector<CameraRecord> cameras() const {
    const DocumentNode* frames = root_->find("frames");
    if (frames == nullptr || frames->kind != DocumentNode::Kind::list || frames->items.empty())
      throw InputError(*file_, frames == nullptr ? 0 : frames->line, "there are no frames; add \"frames\": [...]");
    std::vector<CameraRecord> records;
    for (const DocumentNode& frame : frames->items) records.push_back(camera(frame));
    return records;
  }

 private:
  [[nodiscard]] const DocumentNode* find(const DocumentNode& frame, std::string_view key) const {
    const DocumentNode* own = frame.find(key);
    return own != nullptr ? own : root_->find(key);
  }
  [[nodiscard]] std::optional<double> number(const DocumentNode& frame, std::string_view key) const {
    const DocumentNode* node = find(frame, key);
    return node == nullptr ? std::nullopt : std::optional(number_of(*node, *file_, key));
  }

  [[nodiscard]] CameraRecord camera(const DocumentNode& frame) const {
    if (frame.kind != DocumentNode::Kind::table)
      throw InputError(*file_, frame.line,
                       "a frame is no table; write {\"file_path\": ..., \"transform_matrix\": ...}");
    CameraRecord record;
    const DocumentNode* path = frame.find("file_path");
    record.name = path == nullptr ? "frame" : path->text;
    record.line = frame.line;
    record.image = calibration(frame);
    record.place = camera_pose(matrix(frame), CameraAxes::opengl);
    return record;
  }

  [[nodiscard]] Matrix34 matrix(const DocumentNode& frame) const {
    const DocumentNode* node = frame.find("transform_matrix");
    if (node == nullptr) throw InputError(*file_, frame.line, "the frame has no transform_matrix; add it");
    const std::vector<double> values = numbers_of(*node, *file_, "transform_matrix");
    const bool is_4x4 = values.size() == 16;
    if (!is_4x4 && values.size() != 12) {
      throw InputError(*file_, node->line,
                       fmt::format("'transform_matrix' has {} numbers; it must be 4x4 or 3x4", values.size()));
    }
    if (is_4x4 && !(values[12] == 0 && values[13] == 0 && values[14] == 0 && values[15] == 1))
      throw InputError(*file_, node->line, "the last row of 'transform_matrix' must be [0, 0, 0, 1]");
    return Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(values.data());
  }

  // A focal length in pixels: as it is written, or of an angle over the image.
  [[nodiscard]] std::optional<double> focal_length(const DocumentNode& frame, const char* key, const char* angle_key,
                                                   double size) const {
    if (const auto length = number(frame, key)) return length;
    const auto angle = number(frame, angle_key);
    if (!angle) return std::nullopt;
    if (!(*angle > 0 && *angle < std::numbers::pi)) {
      throw InputError(*file_, find(frame, angle_key)->line,
                       fmt::format("'{}' must be an angle in radians, between 0 and pi", angle_key));
    }
    return size / 2 / std::tan(*angle / 2);
  }

  [[nodiscard]] Calibration calibration(const DocumentNode& frame) const {
    Calibration calibration;
    const auto [width, height] =
        image_size({number(frame, "w").value_or(0), number(frame, "h").value_or(0)}, *request_, *file_, frame.line);
    calibration.width = width;
    calibration.height = height;
    calibration.origin = request_->origin.value_or(PixelOrigin::corner);
    const auto fx = focal_length(frame, "fl_x", "camera_angle_x", width);
    if (!fx) throw InputError(*file_, frame.line, "there is neither fl_x nor camera_angle_x; add one of them");
    const double fy = focal_length(frame, "fl_y", "camera_angle_y", height).value_or(*fx);
    calibration.k << *fx, 0, number(frame, "cx").value_or(width / 2),  //
        0, fy, number(frame, "cy").value_or(height / 2), 0, 0, 1;
    calibration.lens = lens(frame);
    return calibration;
  }

  [[nodiscard]] bool is_fisheye(const DocumentNode& frame) const {
    const DocumentNode* flag = find(frame, "is_fisheye");
    if (flag != nullptr && flag->text == "true") return true;
    const DocumentNode* model = find(frame, "camera_model");
    if (model == nullptr || model->text == "OPENCV" || model->text == "PINHOLE" || model->text == "SIMPLE_PINHOLE" ||
        model->text == "SIMPLE_RADIAL" || model->text == "RADIAL")
      return false;
    if (model->text == "OPENCV_FISHEYE") return true;
    throw InputError(*file_, model->line,
                     fmt::format("the camera model \"{}\" is not read; undistort the images, and take their transforms",
                                 printable(model->text)));
  }

  [[nodiscard]] std::optional<Lens> lens(const DocumentNode& frame) const {
    constexpr std::array<std::string_view, 6> radial{"k1", "k2", "k3", "k4", "k5", "k6"};
    Lens lens;
    lens.model = is_fisheye(frame) ? LensModel::fisheye : LensModel::brown;
    for (std::size_t i = 0; i < radial.size(); ++i) lens.radial[i] = number(frame, radial[i]).value_or(0);
    lens.tangential = {number(frame, "p1").value_or(0), number(frame, "p2").value_or(0)};
    return lens;
  }

  const DocumentNode* root_;
  const std::string* file_;
  const CameraRequest* request_;
};

}  // namespace

std::vector<CameraRecord> read_transforms(const DocumentNode& root, const std::string& file,
                                          const CameraRequest& request) {
  return TransformsReader(root, file, request).cameras();
}

}  // namespace sightline::cli
