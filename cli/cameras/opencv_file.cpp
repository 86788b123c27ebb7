#include "cli/cameras/opencv_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "cli/cameras/rotations.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

// Returns the key in small letters, without what separates words.
std::string bare_key(std::string_view key) {
  std::string bare;
  for (const char c : key) {
    if (c != '_' && c != '-') bare += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return bare;
}

class OpencvReader {
 public:
  OpencvReader(const DocumentNode& root, const std::string& file, const CameraRequest& request)
      : root_(&root), file_(&file), request_(&request) {}

  [[nodiscard]] std::vector<CameraRecord> cameras() const {
    if (has({"cameramatrix1", "m1"})) return stereo();
    if (has({"cameramatrix", "k", "mtx", "intrinsicmatrix"})) return single();
    if (has({"p1"}) && has({"p2"})) return rectified();
    throw InputError(*file_, 0,
                     "there is no camera_matrix, nor cameraMatrix1 and 2, nor P1 and P2; name a file of a calibration");
  }

 private:
  using Keys = std::initializer_list<std::string_view>;  // spellings of one, bare; the first is for messages

  [[nodiscard]] const DocumentMember* find(Keys keys) const {
    for (const DocumentMember& member : root_->members) {
      if (std::ranges::find(keys, bare_key(member.key)) != keys.end()) return &member;
    }
    return nullptr;
  }
  [[nodiscard]] bool has(Keys keys) const { return find(keys) != nullptr; }
  [[nodiscard]] const DocumentMember& required(Keys keys, const char* name) const {
    const DocumentMember* member = find(keys);
    if (member == nullptr) throw InputError(*file_, 0, fmt::format("there is no {}; add it", name));
    return *member;
  }

  [[noreturn]] void fail(const DocumentMember& member, const std::string& cause) const {
    throw InputError(*file_, member.value.line, fmt::format("'{}' {}", printable(member.key), cause));
  }

  // The numbers of a matrix, row by row; rows and columns, where they are said, have to agree with how many there are.
  [[nodiscard]] std::vector<double> entries(const DocumentMember& member) const {
    const DocumentNode& node = member.value;
    if (node.kind != DocumentNode::Kind::table) return numbers_of(node, *file_, member.key);
    const DocumentNode* data = node.find("data");
    if (data == nullptr) fail(member, "has no data; write rows, cols and data");
    std::vector<double> values = numbers_of(*data, *file_, member.key);
    const DocumentNode* rows = node.find("rows");
    const DocumentNode* columns = node.find("cols");
    if (rows == nullptr || columns == nullptr) fail(member, "has no rows or no cols; write both");
    const double expected = number_of(*rows, *file_, "rows") * number_of(*columns, *file_, "cols");
    if (expected != static_cast<double>(values.size()))
      fail(member, fmt::format("has {} numbers, and not rows x cols; correct one of them", values.size()));
    return values;
  }
  [[nodiscard]] std::vector<double> entries(const DocumentMember& member, std::size_t size, const char* shape) const {
    std::vector<double> values = entries(member);
    if (values.size() != size) fail(member, fmt::format("has {} numbers; it must be {}", values.size(), shape));
    return values;
  }
  [[nodiscard]] Matrix3 matrix(const DocumentMember& member) const {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(entries(member, 9, "3x3").data());
  }
  [[nodiscard]] Vector3 vector(const DocumentMember& member) const {
    return Eigen::Map<const Vector3>(entries(member, 3, "3x1").data());
  }
  // R is a matrix, or a rotation vector.
  [[nodiscard]] Matrix3 rotation(const DocumentMember& member) const {
    return entries(member).size() == 3 ? rotation_of_vector(vector(member)) : matrix(member);
  }

  [[nodiscard]] std::array<double, 2> size(std::size_t line) const {
    std::array<double, 2> in_file{};
    if (const DocumentMember* both = find({"imagesize"})) {
      const std::vector<double> values = entries(*both, 2, "two numbers");
      in_file = {values[0], values[1]};
    }
    if (const DocumentMember* width = find({"imagewidth"})) in_file[0] = number_of(width->value, *file_, width->key);
    if (const DocumentMember* height = find({"imageheight"}))
      in_file[1] = number_of(height->value, *file_, height->key);
    return image_size(in_file, *request_, *file_, line);
  }

  [[nodiscard]] LensModel lens_model() const {
    if (request_->lens_model) return *request_->lens_model;
    if (const DocumentMember* flag = find({"fisheyemodel"}))
      return number_of(flag->value, *file_, flag->key) != 0 ? LensModel::fisheye : LensModel::brown;
    const DocumentMember* model = find({"distortionmodel"});
    if (model == nullptr || model->value.text == "plumb_bob" || model->value.text == "rational_polynomial")
      return LensModel::brown;
    if (model->value.text != "equidistant" && model->value.text != "fisheye")
      fail(*model, "is none that is known; undistort the images, and give the calibration of these");
    return LensModel::fisheye;
  }

  [[nodiscard]] Lens lens(const DocumentMember& member) const {
    const std::vector<double> k = entries(member);
    Lens lens;
    lens.model = lens_model();
    if (lens.model == LensModel::fisheye) {
      if (k.size() != 4) fail(member, fmt::format("has {} numbers; give the four of a fisheye: k1 k2 k3 k4", k.size()));
      std::ranges::copy(k, lens.radial.begin());
      return lens;
    }
    for (const std::size_t count : {4U, 5U, 8U, 12U, 14U}) {
      if (k.size() == count) return brown(k, member);
    }
    fail(member, fmt::format("has {} numbers; give 4, 5, 8, 12 or 14: k1 k2 p1 p2 k3 k4 k5 k6 ...", k.size()));
  }
  [[nodiscard]] Lens brown(const std::vector<double>& k, const DocumentMember& member) const {
    for (std::size_t i = 8; i < k.size(); ++i) {
      if (k[i] != 0) fail(member, "has a thin prism or a tilt; calibrate without them, or undistort the images");
    }
    Lens lens;
    lens.tangential = {k[2], k[3]};
    lens.radial[0] = k[0];
    lens.radial[1] = k[1];
    for (std::size_t i = 4; i < std::min<std::size_t>(k.size(), 8); ++i) lens.radial[i - 2] = k[i];
    return lens;
  }

  [[nodiscard]] CameraRecord camera(std::string name, Keys matrix_keys, Keys lens_keys) const {
    const DocumentMember& k = required(matrix_keys, "camera matrix of the second camera");
    Calibration calibration;
    calibration.k = matrix(k);
    const auto [width, height] = size(k.value.line);
    calibration.width = width;
    calibration.height = height;
    calibration.origin = request_->origin.value_or(PixelOrigin::center);
    if (const DocumentMember* coefficients = find(lens_keys)) calibration.lens = lens(*coefficients);
    CameraRecord record;
    record.name = std::move(name);
    record.line = k.value.line;
    record.image = calibration;
    return record;
  }

  [[nodiscard]] std::vector<CameraRecord> single() const {
    CameraRecord record = camera("camera", {"cameramatrix", "k", "mtx", "intrinsicmatrix"},
                                 {"distortioncoefficients", "distcoeffs", "distortioncoeffs", "dist", "d"});
    const DocumentMember* r = find({"r", "rvec", "rotation"});
    const DocumentMember* t = find({"t", "tvec", "translation"});
    if (const DocumentMember* rows = find({"extrinsicparameters"}); rows != nullptr && t == nullptr)
      return views(record, *rows);
    if (r != nullptr && t != nullptr) record.place = WorldToCamera{rotation(*r), vector(*t)};
    return {record};
  }

  [[nodiscard]] std::vector<CameraRecord> views(const CameraRecord& camera, const DocumentMember& rows) const {
    const std::vector<double> values = entries(rows);
    if (values.empty() || values.size() % 6 != 0)
      fail(rows, "must have six numbers a row: a rotation vector and a translation");
    std::vector<CameraRecord> records;
    for (std::size_t i = 0; 6 * i < values.size(); ++i) {
      const double* const row = values.data() + 6 * i;
      records.push_back(camera);
      records.back().name = numbered("view", i, values.size() / 6);
      records.back().line = rows.value.line;
      records.back().place = WorldToCamera{rotation_of_vector({row[0], row[1], row[2]}), {row[3], row[4], row[5]}};
    }
    return records;
  }

  [[nodiscard]] std::vector<CameraRecord> stereo() const {
    CameraRecord first = camera("camera-01", {"cameramatrix1", "m1"}, {"distcoeffs1", "d1", "distortioncoefficients1"});
    CameraRecord second =
        camera("camera-02", {"cameramatrix2", "m2"}, {"distcoeffs2", "d2", "distortioncoefficients2"});
    const DocumentMember* r = find({"r"});
    const DocumentMember* t = find({"t"});
    if (r != nullptr && t != nullptr) {
      first.place = WorldToCamera{};
      second.place = WorldToCamera{rotation(*r), vector(*t)};
    }
    return {first, second};
  }

  // P is K [1 | t], of the frame that rectifying gives the first camera.
  [[nodiscard]] CameraRecord rectified_camera(std::string name, const DocumentMember& member) const {
    const std::vector<double> values = entries(member, 12, "3x4");
    const Matrix34 p = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(values.data());
    Calibration calibration;
    calibration.k = p.leftCols<3>();
    const auto [width, height] = size(member.value.line);
    calibration.width = width;
    calibration.height = height;
    calibration.origin = request_->origin.value_or(PixelOrigin::center);
    CameraRecord record;
    record.name = std::move(name);
    record.line = member.value.line;
    record.image = calibration;
    if (p(0, 0) == 0 || p(1, 1) == 0 || p(2, 2) != 1 || p(2, 3) != 0)
      fail(member, "is none of a rectified pair; write it as [[f, 0, cx, x], [0, f, cy, y], [0, 0, 1, 0]]");
    record.place = WorldToCamera{Matrix3::Identity(), {p(0, 3) / p(0, 0), p(1, 3) / p(1, 1), 0}};
    return record;
  }
  [[nodiscard]] std::vector<CameraRecord> rectified() const {
    CameraRecord first = rectified_camera("camera-01", *find({"p1"}));
    return {std::move(first), rectified_camera("camera-02", *find({"p2"}))};
  }

  const DocumentNode* root_;
  const std::string* file_;
  const CameraRequest* request_;
};

// Two spellings of one key in a file would make it a matter of their order which of them counts.
void refuse_two_spellings(const DocumentNode& root, const std::string& file) {
  std::vector<std::pair<std::string, std::size_t>> keys;
  for (const DocumentMember& member : root.members) keys.emplace_back(bare_key(member.key), member.value.line);
  std::ranges::sort(keys);
  const auto same = std::ranges::adjacent_find(keys, [](const auto& a, const auto& b) { return a.first == b.first; });
  if (same == keys.end()) return;
  const auto& [key, line] = *(same + 1);
  throw InputError(file, line, fmt::format("'{}' is there in two spellings; remove one of them", printable(key)));
}

}  // namespace

std::vector<CameraRecord> read_opencv(const DocumentNode& root, const std::string& file, const CameraRequest& request) {
  refuse_two_spellings(root, file);
  return OpencvReader(root, file, request).cameras();
}

}  // namespace sightline::cli
