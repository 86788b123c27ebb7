// Files of cameras: what is read of each format, and what is refused, with which remedy.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "cli/cameras/camera_files.h"
#include "cli/scene/camera_names.h"
#include "cli/scene/result_names.h"
#include "geometry/numbers/errors.h"
#include "tests/tools/command_runner.h"
#include "tests/tools/says_what_to_do.h"
#include "tests/tools/scene_texts.h"

namespace sightline::tests::camera_files_test {
using namespace cli;

namespace {

const std::string matrix_3x3 = "{rows: 3, cols: 3, dt: d, data: [500, 0, 320, 0, 500, 240, 0, 0, 1]}\n";
const std::string size_lines = "image_width: 640\nimage_height: 480\n";

std::vector<CameraRecord> records_of(const std::string& text, CameraRequest request = {}) {
  request.file = "dir/input";
  return read_camera_file(request, [&text](const std::string& /*path*/) { return text; });
}

const Calibration& calibration_of(const CameraRecord& record) { return std::get<Calibration>(record.image); }

void check_refused(const std::string& text, std::size_t line, const std::string& says,
                   const std::string& more = "image = [640, 480]\n") {
  INFO(text.substr(0, 400));
  try {
    static_cast<void>(scene_of("[[cameras]]\nfile = \"input\"\n" + more, {{"dir/input", text}}));
    FAIL_CHECK("the file was accepted");
  } catch (const InputError& error) {
    const std::string what = error.what();
    INFO(what);
    CHECK(error.line() == line);
    CHECK(what.starts_with("dir/input:"));
    CHECK(std::ranges::none_of(what, [](char c) { return static_cast<unsigned char>(c) < 0x20; }));
    CHECK(what.find(says) != std::string::npos);
    CHECK(what.size() < 500);
    CHECK(says_what_to_do(what));
  }
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

std::optional<std::string> shared_file(const std::string& name) {
  const char* variable = std::getenv("SIGHTLINE_SHARED_DIR");
  const std::filesystem::path folder = variable != nullptr ? variable : SIGHTLINE_SHARED_DIR;
  const std::filesystem::path file = folder / "cameras" / name;
  return std::filesystem::exists(file) ? std::optional(read_text(file)) : std::nullopt;
}

}  // namespace

TEST_CASE("OpenCV's own calibration of a chessboard is read with its poses, its lens and all digits") {
  const auto text = shared_file("opencv_left_intrinsics.yml");
  if (!text) return;
  const auto records = records_of(*text);
  REQUIRE(records.size() == 2);
  CHECK(records[0].name == "view-01");
  CHECK(records[1].name == "view-02");
  const Calibration& calibration = calibration_of(records[1]);
  CHECK(calibration.k == Matrix3{{5.3591573396163199e+02, 0, 3.4228315473308373e+02},
                                 {0, 5.3591573396163199e+02, 2.3557082909788173e+02},
                                 {0, 0, 1}});
  CHECK(calibration.width == 640);
  CHECK(calibration.height == 480);
  CHECK(calibration.origin == PixelOrigin::center);
  REQUIRE(calibration.lens.has_value());
  CHECK(calibration.lens->model == LensModel::brown);
  CHECK(calibration.lens->radial ==
        std::array<double, 6>{-2.6637260909660682e-01, -3.8588898922304653e-02, 2.3839153080878486e-01, 0, 0, 0});
  CHECK(calibration.lens->tangential == std::array<double, 2>{1.7831947042852964e-03, -2.8122100441115472e-04});
  const auto& pose = std::get<WorldToCamera>(records[1].place);
  CHECK(pose.t == Vector3{-5.8571677080547203e-02, 8.2925805670236566e-02, 3.5381014833230601e-01});
  const Vector3 turn{4.1331287656496363e-01, 6.4989015618432178e-01, -1.3371537960145106e+00};
  const Matrix3 expected = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  CHECK((pose.r - expected).cwiseAbs().maxCoeff() <= 1e-15);
}

TEST_CASE("an old file of OpenCV, with other spellings and three digits of exponents, is read") {
  const auto text = shared_file("opencv_out_camera_data.yml");
  if (!text) return;
  const auto records = records_of(*text);
  REQUIRE(records.size() == 2);
  CHECK(calibration_of(records[0]).k(0, 0) == 6.5746697810243404e+2);
  CHECK(calibration_of(records[0]).width == 640);
  CHECK(calibration_of(records[0]).lens->radial[2] == -5.7843596847939704e-1);
  CHECK(std::get<WorldToCamera>(records[0].place).t.z() == 6.2576484126093249e+2);
}

TEST_CASE("the transforms of a NeRF are read, and are called as their images") {
  const auto text = shared_file("nerf_transforms.json");
  if (!text) return;
  const auto records = records_of(*text);
  REQUIRE(records.size() == 2);
  CHECK(records[0].name == "./images/2.jpeg");
  CHECK(folder_name(records[0].name) == "2");
  const Calibration& calibration = calibration_of(records[0]);
  CHECK(calibration.k ==
        Matrix3{{566.191211780802, 0, 423.1549573255917}, {0, 840.2947458466756, 694.4115142027817}, {0, 0, 1}});
  CHECK(calibration.origin == PixelOrigin::corner);
  CHECK(calibration.lens->tangential == std::array<double, 2>{0.009328837304472766, 0.024846395951254437});
  const auto& pose = std::get<CameraPose>(records[0].place);
  CHECK(pose.eye == Point3{4.05565502884002, 0.6629492788350203, -0.15964845788974524});
  CHECK(pose.rotation.row(2) == Eigen::RowVector3d{-0.9689994767017668, -0.24698625655116735, 0.006148434291393159});
  CHECK(pose.rotation.row(1) == Eigen::RowVector3d{-0.017791267178866095, 0.0449356138876566, -0.9988314479612639});
  CHECK(pose.rotation.row(0) == Eigen::RowVector3d{-0.2464213565896389, 0.9679765388063376, 0.047936784822221704});
}

TEST_CASE("COLMAP's cameras of a real data set are read") {
  const auto text = shared_file("colmap_cameras.txt");
  if (!text) return;
  const auto records = records_of(*text);
  REQUIRE(records.size() == 1);
  CHECK(records[0].name == "camera-1");
  CHECK(calibration_of(records[0]).k == Matrix3{{3688.28, 0, 2592}, {0, 3688.28, 1944}, {0, 0, 1}});
  CHECK(calibration_of(records[0]).lens->radial[0] == -0.00686798);
}

TEST_CASE("COLMAP's models become lenses, and each image gets its camera") {
  const std::string cameras =
      "# comment\n1 SIMPLE_PINHOLE 64 48 50 32 24\n2 PINHOLE 64 48 50 51 32 24\n3 SIMPLE_RADIAL 64 48 50 32 24 .1\n"
      "4 RADIAL 64 48 50 32 24 .1 .2\n5 OPENCV 64 48 50 51 32 24 .1 .2 .3 .4\n"
      "6 OPENCV_FISHEYE 64 48 50 51 32 24 .1 .2 .3 .4\n7 FULL_OPENCV 64 48 50 51 32 24 .1 .2 .3 .4 .5 .6 .7 .8\n"
      "8 SIMPLE_RADIAL_FISHEYE 64 48 50 32 24 .1\n9 RADIAL_FISHEYE 64 48 50 32 24 .1 .2\n"
      "10 THIN_PRISM_FISHEYE 64 48 50 51 32 24 .1 .2 .3 .4 .5 .6 .7 .8\n11 FOV 64 48 50 51 32 24 -.9\n"
      "12 FOV 64 48 50 51 32 24 0\n";
  const auto records = records_of(cameras);
  REQUIRE(records.size() == 12);
  using Radial = std::array<double, 6>;
  const std::vector<std::pair<LensModel, Radial>> expected{
      {LensModel::brown, {.1}},
      {LensModel::brown, {.1, .2}},
      {LensModel::brown, {.1, .2}},
      {LensModel::fisheye, {.1, .2, .3, .4}},
      {LensModel::brown, {.1, .2, .5, .6, .7, .8}},
      {LensModel::fisheye, {.1}},
      {LensModel::fisheye, {.1, .2}},
      {LensModel::fisheye, {.1, .2, .5, .6}},
      {LensModel::field_of_view, {.9}},
      {LensModel::brown, {}},
  };
  CHECK_FALSE(calibration_of(records[0]).lens.has_value());
  CHECK(calibration_of(records[1]).k(1, 1) == 51);
  CHECK(calibration_of(records[1]).k(1, 2) == 24);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Lens& lens = *calibration_of(records[i + 2]).lens;
    INFO(records[i + 2].name);
    CHECK(lens.model == expected[i].first);
    CHECK(lens.radial == expected[i].second);
    const bool is_tangential = i == 2 || i == 4 || i == 7;
    CHECK(lens.prism == (i == 7 ? std::array<double, 2>{.7, .8} : std::array<double, 2>{}));
    CHECK(lens.tangential == (is_tangential ? std::array<double, 2>{.3, .4} : std::array<double, 2>{}));
  }
  const FileTexts files{{"dir/images.txt",
                         "# Image list with two lines of data per image:\n1 1 0 0 0 0 0 4 2 day 1/a b.png\n"
                         "1.5 2.5 -1 3 4 7\n3 0 2 0 0 1 2 3 1 day 2/a b.png\n\n"},
                        {"dir/cameras.txt", cameras}};
  const auto scene = scene_of("[[cameras]]\nfile = \"images.txt\"\nprefix = \"d-\"\nnear = 1\n", files);
  REQUIRE(scene.cameras.size() == 2);
  CHECK(scene.cameras[0].name == "d-a b");
  CHECK(scene.cameras[1].name == "d-a b-2");
  CHECK(scene.cameras[0].near_distance == 1.0);
  CHECK(scene.cameras[1].origin == Point3{-1, 2, 3});
}

TEST_CASE("stereo files have two cameras: of the calibrations, or rectified") {
  const std::string stereo = size_lines + "M1: " + matrix_3x3 + "D1: [0, 0, 0, 0]\nM2: " + matrix_3x3 +
                             "R: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT: [-2, 0, 0]\n";
  const auto records = records_of(stereo);
  REQUIRE(records.size() == 2);
  CHECK(std::get<WorldToCamera>(records[0].place).t == Vector3{0, 0, 0});
  CHECK(std::get<WorldToCamera>(records[1].place).t == Vector3{-2, 0, 0});
  const auto rectified = records_of(
      "P1: [500, 0, 320, 0, 0, 500, 240, 0, 0, 0, 1, 0]\nP2: [500, 0, 320, -1000, 0, 500, 240, 0, 0, 0, 1, 0]\n");
  REQUIRE(rectified.size() == 2);
  CHECK(std::get<WorldToCamera>(rectified[1].place).t == Vector3{-2, 0, 0});
}

TEST_CASE("the calibration of one file goes with the poses of another, and with a pose of the scene file") {
  const FileTexts files{{"dir/k.yml", size_lines + "camera_matrix: " + matrix_3x3},
                        {"dir/poses.csv", "tx,ty,tz,qw,qx,qy,qz\n0,0,4,1,0,0,0\n0,0,5,1,0,0,0\n"}};
  const std::string poses =
      "[[cameras]]\nfile = \"poses.csv\"\nintrinsics = \"k.yml\"\npose = \"world_to_camera\"\naxes = \"opencv\"\n";
  const auto scene = scene_of(poses +
                                  "[[cameras]]\nfile = \"k.yml\"\nR = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
                                  "t = [0, 0, 6]\n",
                              files);
  REQUIRE(scene.cameras.size() == 3);
  CHECK(scene.cameras[0].name == "camera-01");
  CHECK(scene.cameras[1].origin == Point3{0, 0, -5});
  CHECK(scene.cameras[2].name == "camera");
  CHECK(scene.cameras[2].origin == Point3{0, 0, -6});
}

TEST_CASE("an angle alone is a focal length, and a frame's own intrinsics come first") {
  const std::string text = R"({"camera_angle_x": 1.0, "w": 640, "h": 480, "frames": [
    {"file_path": "a", "transform_matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,4],[0,0,0,1]]},
    {"file_path": "b", "transform_matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,4],[0,0,0,1]], "fl_x": 100, "fl_y": 101, "cx": 7}]})";
  const auto records = records_of(text);
  REQUIRE(records.size() == 2);
  CHECK(calibration_of(records[0]).k(0, 0) == doctest::Approx(320 / std::tan(0.5)).epsilon(1e-15));
  CHECK(calibration_of(records[0]).k(1, 2) == 240);
  CHECK(calibration_of(records[1]).k == Matrix3{{100, 0, 7}, {0, 101, 240}, {0, 0, 1}});
}

TEST_CASE("cameras of a file are chosen by name, or every n-th") {
  std::string table = "name,eye_x,eye_y,eye_z,target_x,target_y,target_z,fov_x_deg\n";
  for (int i = 0; i < 10; ++i) table += std::to_string(i) + ".png,0,0," + std::to_string(i + 1) + ",0,0,0,40\n";
  const auto names = [&](const std::string& keys) {
    std::string text;
    for (const Camera& c : scene_of("[[cameras]]\nfile = \"t.csv\"\n" + keys, {{"dir/t.csv", table}}).cameras)
      text += c.name + " ";
    return text;
  };
  CHECK(names("every = 4\n") == "0 4 8 ");
  CHECK(names("select = [\"7\", \"2\"]\n") == "2 7 ");
  CHECK(names("prefix = \"p\"\nevery = 9\n") == "p0 p9 ");
  CHECK_THROWS_WITH_AS(names("select = [\"11\"]\n"), doctest::Contains("the file has no camera '11'"), InputError);
  CHECK_THROWS_WITH_AS(names("every = 0\n"), doctest::Contains("'every' must be a whole number"), InputError);
  CHECK_THROWS_WITH_AS(names("prefix = \"a/\"\n"), doctest::Contains("has one of /"), InputError);
}

TEST_CASE("names of files become names of folders, and stay distinct") {
  CHECK(folder_name("./images/2.jpeg") == "2");
  CHECK(folder_name("C:\\a\\b.JPG") == "b");
  CHECK(folder_name("IMG_1.25") == "IMG_1.25");
  CHECK(folder_name("../..") == "camera");
  CHECK(folder_name("") == "camera");
  CHECK(folder_name(".hidden") == "hidden");
  CHECK(folder_name("a?b*c.png") == "a-b-c");
  CHECK(folder_name("a\nb\xC2\x80"
                    "c\xFF") == "a-b-c");
  CHECK(folder_name("h\xC3\xB6he.png") == "h\xC3\xB6he");
  CHECK(folder_name(std::string(1000, 'a')).size() == 80);
  DistinctNames names;
  CHECK(names.next("a") == "a");
  CHECK(names.next("a-2") == "a-2");
  CHECK(names.next("a") == "a-3");
  CHECK(names.next("Coverage.csv") == "Coverage.csv-2");
}

TEST_CASE("what is wrong with a file of cameras is said with its line and what to do") {
  const std::string head = "%YAML:1.0\n---\n" + size_lines;
  check_refused("", 0, "no file of cameras that is known");
  check_refused("hello\n", 0, "no file of cameras that is known");
  check_refused(std::string("\x01\0\0\0\0\0", 6), 0, "colmap model_converter");
  check_refused(head + "camera_matrix: {rows: 3, cols: 3, data: [1, 2]}\n", 5, "has 2 numbers, and not rows x cols");
  check_refused(head + "camera_matrix: {rows: 1000000000, cols: 1000000000, data: [1]}\n", 5, "not rows x cols");
  check_refused(head + "camera_matrix: [1, 2, 3]\n", 5, "it must be 3x3");
  check_refused(head + "camera_matrix: [1, 2, x, 0, 0, 0, 0, 0, 0]\n", 5, "\"x\", which is no finite number");
  check_refused(head + "camera_matrix: [.Nan, 2, 3, 0, 0, 0, 0, 0, 0]\n", 5, "no finite number");
  check_refused(head + "camera_matrix: [1e999, 2, 3, 0, 0, 0, 0, 0, 0]\n", 5, "no finite number");
  check_refused(head + "camera_matrix: " + matrix_3x3, 5, "does not say where it is");
  check_refused(head + "camera_matrix: " + matrix_3x3 + "rvec: [0, 0, 0]\ntvec: [0, 0, 4]\nrvec: [0, 0, 0]\n", 8,
                "a second 'rvec'");
  check_refused(head + "camera_matrix: " + matrix_3x3 + "Camera_Matrix: " + matrix_3x3, 6, "in two spellings");
  check_refused(head + "nothing: 1\n", 0, "there is no camera_matrix");
  check_refused(head + "a: [1,\n", 6, "not valid YAML");
  check_refused(head + "a: &x 1\nb: *x\n", 6, "an alias");
  check_refused(head + "distortion_coefficients: [1, 2, 3]\ncamera_matrix: " + matrix_3x3, 5, "has 3 numbers");
  check_refused(
      head + "camera_matrix: " + matrix_3x3 + "distortion_coefficients: [0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0]\n", 6,
      "thin prism");
  check_refused(size_lines + "camera_matrix: " + matrix_3x3 + "rvec: [0, 0, 0]\ntvec: [0, 0, 4]\n", 3,
                "the image is 640 x 480 here, and 64 x 48 in the scene file", "image = [64, 48]\n");
  check_refused("camera_matrix: " + matrix_3x3 + "rvec: [0, 0, 0]\ntvec: [0, 0, 4]\n", 1,
                "does not say the size of the image", "");
  check_refused("<opencv_storage><a>1</b></opencv_storage>", 1, "not valid XML");
  check_refused("<html></html>", 1, "XML that is not OpenCV's");
  check_refused("<!DOCTYPE a>\n<opencv_storage></opencv_storage>", 1, "a document type");
  check_refused("{\"frames\": [\n1,\n]}", 3, "not valid JSON");
  check_refused("{\"frames\": [],\n\"frames\": []}", 2, "a second 'frames'");
  check_refused("{\"frames\": []}", 1, "there are no frames");
  check_refused("{\"fl_x\": 1, \"frames\": [\n{\"file_path\": \"a\"}]}", 2, "no transform_matrix");
  check_refused("{\"frames\": [\n{\"transform_matrix\": [1, 2]}]}", 2, "neither fl_x nor camera_angle_x");
  check_refused("{\"fl_x\": 1, \"frames\": [\n{\"transform_matrix\": [[2,0,0,0],[0,2,0,0],[0,0,2,0]]}]}", 2,
                "R is not a rotation");
  check_refused("1 RAD_TAN_THIN_PRISM_FISHEYE 64 48 50 51 32 24 .1\n", 1, "colmap image_undistorter");
  check_refused("1 FOV 64 48 50 51 32 24 3.2\n", 1, "not between 0 and pi",
                "R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nt = [0, 0, 0]\n");
  check_refused("1 PINHOLE 64 48 50\n", 1, "PINHOLE has 6 numbers, and here are 3");
  check_refused("1 PINHOLE 640 480 50 50 32 24\n1 PINHOLE 640 480 50 50 32 24\n", 2, "a second camera 1");
  check_refused("name,eye_x\na,1\n", 1, "no column eye_y");
  check_refused("name,depth\na,1\n", 1, "unknown column 'depth'");
  check_refused("eye_x,eye_y,eye_z,target_x,target_y,target_z,fov_y_deg\n0,0,5,0,0,0\n", 2, "6 fields", "");
  check_refused("eye_x,eye_y,eye_z,target_x,target_y,target_z,fov_y_deg\n0,0,5,0,0,0,400\n", 2, "between 0 and 180",
                "");
  check_refused("eye_x,eye_y,eye_z,target_x,target_y,target_z\n0,0,5,0,0,0\n", 2, "add fov_y_deg, or intrinsics", "");
  check_refused("name,tx,ty,tz,qw,qx,qy,qz\na,0,0,1,1,0,0,0\n", 1, "say in [[cameras]] what they mean", "");
}

TEST_CASE("a lens that bends rays is the camera's, one of zeros is none, one that folds is refused") {
  const auto camera = [](const std::string& coefficients, const std::string& more) {
    return size_lines + "camera_matrix: " + matrix_3x3 + "distortion_coefficients: [" + coefficients +
           "]\nrvec: [0, 0, 0]\ntvec: [0, 0, 4]\n" + more;
  };
  const auto lens_image = [&](const std::string& text) {
    return scene_of("[[cameras]]\nfile = \"k\"\n", {{"dir/k", text}}).cameras.at(0).lens_image;
  };
  REQUIRE(lens_image(camera("0.1, 0, 0, 0", "")).has_value());
  CHECK(lens_image(camera("0.1, 0, 0, 0", ""))->lens.radial[0] == 0.1);
  REQUIRE(lens_image(camera("0, 0, 0, 0", "fisheye_model: 1\n")).has_value());
  CHECK(lens_image(camera("0, 0, 0, 0", "fisheye_model: 1\n"))->lens.model == LensModel::fisheye);
  CHECK_FALSE(lens_image(camera("0, 0, 0, 0, 0", "")).has_value());

  const std::string bent = camera("0.1, 0, 0, 0", "");
  const std::string coarse = "[[cameras]]\nfile = \"k\"\nframe_tolerance = 2\n";
  const auto frame = scene_of(coarse, {{"dir/k", bent}}).cameras.at(0).lens_image;
  CHECK(frame->frame_tolerance == 2);
  CHECK(frame->frame.size() < lens_image(bent)->frame.size());
  CHECK_THROWS_WITH((void)scene_of(coarse, {{"dir/k", camera("0, 0, 0, 0, 0", "")}}),
                    doctest::Contains("no camera of the group has a lens"));
  check_refused(camera("-9, 0, 0, 0", ""), 3, "fold");
}

TEST_CASE("hostile files of cameras are refused in a moment, whatever their size") {
  check_refused("{\"frames\": " + repeated("[", 1000000), 1, "more than 64 levels");
  check_refused("a: " + repeated("[", 1000000), 1, "");
  check_refused("<opencv_storage>" + repeated("<a>", 1000000), 1, "more than 64 levels");
  check_refused("{\"frames\": [" + repeated("0,", 4100000) + "0]}", 1, "more than 4000000 values");
  check_refused("{\"w\": 1" + repeated("0", 1000000) + ", \"frames\": [{}]}", 1, "number overflow");
  check_refused(size_lines + "camera_matrix: [" + std::string(1000000, 'x') + "]\n", 3, "no finite number");
  check_refused("1 " + std::string(1000000, 'A') + " 1 1 1\n", 1, "is not read");
  check_refused(repeated("name,", 100000) + "\n", 1, "a second column name");
}

}  // namespace sightline::tests::camera_files_test
