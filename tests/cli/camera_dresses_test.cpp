// One camera, written in every form that scene files and files of cameras have, is one camera.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/tools/command_runner.h"
#include "tests/tools/scene_texts.h"

namespace sightline::tests::camera_dresses_test {
namespace {

// A camera at (-4, 0.25, 0.5) that looks along x, with z up; 90 degrees high, 640 x 480 pixels. All numbers are exact.
const std::string inline_dresses = R"(
[[camera]]
name = "eye"
eye = [-4, 0.25, 0.5]
target = [0, 0.25, 0.5]
up = [0, 0, 1]
fov_y_deg = 90
aspect = 1.3333333333333333
[[camera]]
name = "focal"
eye = [-4, 0.25, 0.5]
target = [0, 0.25, 0.5]
up = [0, 0, 1]
focal_length_mm = 18
sensor_mm = [48, 36]
[[camera]]
name = "krt"
K = [[240, 0, 320], [0, 240, 240], [0, 0, 1]]
R = [[0, -1, 0], [0, 0, -1], [1, 0, 0]]
t = [0.25, 0.5, 4]
image = [640, 480]
[[camera]]
name = "krt-up"
K = [[240, 0, 320], [0, -240, 240], [0, 0, 1]]
R = [[0, -1, 0], [0, 0, -1], [1, 0, 0]]
t = [0.25, 0.5, 4]
image = [640, 480]
image_y = "up"
[[camera]]
name = "k-opengl"
K = [[240, 0, 320], [0, 240, 240], [0, 0, 1]]
camera_to_world = [[0, 0, -1, -4], [-1, 0, 0, 0.25], [0, 1, 0, 0.5], [0, 0, 0, 1]]
axes = "opengl"
image = [640, 480]
[[camera]]
name = "p"
P = [[320, -240, 0, 1340], [240, 0, -240, 1080], [1, 0, 0, 4]]
image = [640, 480]
[[camera]]
name = "p-up"
P = [[320, -240, 0, 1340], [240, 0, 240, 840], [1, 0, 0, 4]]
image = [640, 480]
image_y = "up"
[[camera]]
name = "opengl"
camera_to_world = [[0, 0, -1, -4], [-1, 0, 0, 0.25], [0, 1, 0, 0.5], [0, 0, 0, 1]]
axes = "opengl"
fov_y_deg = 90
aspect = 1.3333333333333333
[[camera]]
name = "opencv"
camera_to_world = [[0, 0, 1, -4], [-1, 0, 0, 0.25], [0, -1, 0, 0.5]]
axes = "opencv"
fov_y_deg = 90
aspect = 1.3333333333333333
)";

const std::string opencv_matrix_lines =
    "   rows: 3\n   cols: 3\n   dt: d\n   data: [ 240., 0., 319.5, 0.,\n       240., 239.5, 0., 0., 1. ]\n";

const FileTexts dress_files{
    {"calibration.yml", "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n" +
                            opencv_matrix_lines +
                            "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n"
                            "   data: [ 0., 0., 0., 0., 0. ]\n"
                            "R: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
                            "   data: [ 0., -1., 0., 0., 0., -1., 1., 0., 0. ]\n"
                            "T: !!opencv-matrix\n   rows: 3\n   cols: 1\n   dt: d\n   data: [ 2.5000000000000000e-01, "
                            "5.0000000000000000e-001, 4. ]\n"},
    {"calibration.xml",
     "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_Width>640</image_Width>\n<image_Height>480</image_Height>\n"
     "<Camera_Matrix type_id=\"opencv-matrix\">\n  <rows>3</rows>\n  <cols>3</cols>\n  <dt>d</dt>\n  <data>\n"
     "    240. 0. 319.5 0. 240. 239.5 0. 0. 1.</data></Camera_Matrix>\n"
     "<R type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt><data>0. -1. 0. 0. 0. -1. 1. 0. "
     "0.</data></R>\n"
     "<T type_id=\"opencv-matrix\"><rows>3</rows><cols>1</cols><dt>d</dt><data>0.25 0.5 4.</data></T>\n"
     "</opencv_storage>\n"},
    {"calibration.json",
     R"({"image_size": [640, 480],
         "K": {"type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d",
               "data": [240.0, 0.0, 319.5, 0.0, 240.0, 239.5, 0.0, 0.0, 1.0]},
         "R": [[0, -1, 0], [0, 0, -1], [1, 0, 0]], "T": [0.25, 0.5, 4]})"},
    {"images.txt", "# Image list\n1 0.5 0.5 -0.5 0.5 0.25 0.5 4 7 dir/colmap.png\n\n"},
    {"cameras.txt", "# Camera list\n7 PINHOLE 640 480 240 240 320 240\n"},
    {"transforms.json",
     R"({"fl_x": 240, "fl_y": 240.0, "cx": 320, "cy": 240, "w": 640, "h": 480, "k1": 0, "frames": [
         {"file_path": "./images/nerf.png",
          "transform_matrix": [[0, 0, -1, -4], [-1, 0, 0, 0.25], [0, 1, 0, 0.5], [0, 0, 0, 1]]}]})"},
    {"looks.csv",
     "name,eye_x,eye_y,eye_z,target_x,target_y,target_z,up_x,up_y,up_z,fov_y_deg,aspect\n"
     "looks,-4,0.25,0.5,0,0.25,0.5,0,0,1,90,1.3333333333333333\n"},
    {"poses.csv", "name,tx,ty,tz,qw,qx,qy,qz\nposes,0.25,0.5,4,0.5,0.5,-0.5,0.5\n"},
    {"eyes.csv", "name,tx,ty,tz,qw,qx,qy,qz\neyes,-4,0.25,0.5,0.5,-0.5,0.5,-0.5\n"},
};

const std::string group_dresses = R"(
[[cameras]]
file = "calibration.yml"
prefix = "yml-"
[[cameras]]
file = "calibration.xml"
prefix = "xml-"
[[cameras]]
file = "calibration.json"
prefix = "json-"
[[cameras]]
file = "images.txt"
[[cameras]]
file = "transforms.json"
[[cameras]]
file = "looks.csv"
[[cameras]]
file = "poses.csv"
pose = "world_to_camera"
axes = "opencv"
intrinsics = "cameras.txt"
[[cameras]]
file = "eyes.csv"
pose = "camera_to_world"
axes = "opencv"
fov_y_deg = 90
aspect = 1.3333333333333333
)";

FileTexts beside_scene(const FileTexts& files) {
  FileTexts beside;
  for (const auto& [name, text] : files) beside["dir/" + name] = text;
  return beside;
}

bool same_view(const Camera& a, const Camera& b) {
  return a.projection == b.projection && a.right == b.right && a.up == b.up && a.forward == b.forward &&
         a.origin == b.origin && a.eye.xyz == b.eye.xyz && a.eye.w == b.eye.w && a.aspect == b.aspect;
}

// The picture has the camera's name for its title.
std::string without_name(std::string text, const std::string& name) {
  const std::string title = "<title>" + name + "</title>";
  const std::size_t place = text.find(title);
  return place == std::string::npos ? text : text.erase(place, title.size());
}

double difference(const Camera& a, const Camera& b) {
  double largest = 0;
  const auto compare = [&](const Vector3& v, const Vector3& w) {
    largest = std::max(largest, (v - w).cwiseAbs().maxCoeff());
  };
  compare(a.right, b.right);
  compare(a.up, b.up);
  compare(a.forward, b.forward);
  compare(a.origin, b.origin);
  compare(a.eye.xyz, b.eye.xyz);
  return largest;
}

}  // namespace

TEST_CASE("one camera in all dresses is the same camera, bit for bit, where its numbers are exact") {
  const auto cameras = scene_of(inline_dresses + group_dresses, beside_scene(dress_files)).cameras;
  REQUIRE(cameras.size() == 17);
  CHECK(cameras[0].right == Vector3{0, -0.75, 0});
  CHECK(cameras[0].origin == Point3{-4, 0.25, 0.5});
  std::string names;
  for (const Camera& camera : cameras) {
    INFO(camera.name);
    CHECK(same_view(camera, cameras[0]));
    names += camera.name + " ";
  }
  CHECK(names ==
        "eye focal krt krt-up k-opengl p p-up opengl opencv yml-camera xml-camera json-camera colmap nerf looks poses "
        "eyes ");
}

TEST_CASE("one camera in all dresses gives the same bytes of results from the command") {
  const TemporaryFolder folder;
  for (const auto& [name, text] : dress_files) folder.file(name, text);
  folder.file("scene.obj", "v 0 -1 -1\nv 0.3 2 -1\nv 0.1 0 1.7\nv 1 -3 -1\nv 1 3 -2\nv 1.5 0 4\nf 1 2 3\nf 4 5 6\n");
  const std::string scene =
      folder.file("scene.toml", "[mesh]\nfile = \"scene.obj\"\n" + inline_dresses + group_dresses);
  const auto out = folder.path() / "out";
  const RunResult run = run_sightline({"analyze", scene, "-o", out.string()});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  std::size_t folders = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out)) {
    if (!entry.is_directory()) continue;
    ++folders;
    INFO(entry.path().filename().string());
    for (const char* file : {"faces.csv", "segments.csv", "view.svg", "labelled.ply", "labelled.obj"}) {
      INFO(file);
      const std::string text = without_name(read_text(entry.path() / file), entry.path().filename().string());
      CHECK(text.size() > 100);
      CHECK(text == without_name(read_text(out / "eye" / file), "eye"));
    }
    const auto report = nlohmann::json::parse(read_text(entry.path() / "report.json"));
    const auto first = nlohmann::json::parse(read_text(out / "eye" / "report.json"));
    for (const char* member : {"counts", "areas", "sides"}) CHECK(report[member] == first[member]);
    CHECK(report["camera"].contains("matrix_sign") ==
          (entry.path().filename().string().front() == 'p' && entry.path().filename() != "poses"));
    CHECK(report["warnings"] == first["warnings"]);
  }
  CHECK(folders == 17);
}

TEST_CASE("one camera in all dresses is the same to rounding, where its numbers are not exact") {
  // Turned by the angle of 3-4-5 about y, at (3, 0, 4), which looks at the origin.
  const std::string dresses = R"(
[[camera]]
name = "eye"
eye = [3, 0, 4]
target = [0, 0, 0]
fov_y_deg = 90
[[camera]]
name = "x"
eye = [3, 0, 4]
target = [0, 0, 0]
fov_x_deg = 90
[[camera]]
name = "krt"
K = [[100, 0, 100], [0, 100, 100], [0, 0, 1]]
R = [[0.8, 0, -0.6], [0, -1, 0], [-0.6, 0, -0.8]]
t = [0, 0, 5]
image = [200, 200]
[[camera]]
name = "opengl"
camera_to_world = [[0.8, 0, 0.6, 3], [0, 1, 0, 0], [-0.6, 0, 0.8, 4]]
axes = "opengl"
fov_x_deg = 90
[[cameras]]
file = "transforms.json"
[[cameras]]
file = "calibration.yml"
[[cameras]]
file = "images.txt"
)";
  const FileTexts files{
      // Without w and h there would be no size; the angle is that of tan = 1.
      {"transforms.json", R"({"camera_angle_x": 1.5707963267948966, "w": 200, "h": 200, "frames": [{"file_path": "f",
        "transform_matrix": [[0.8, 0, 0.6, 3], [0, 1, 0, 0], [-0.6, 0, 0.8, 4], [0, 0, 0, 1]]}]})"},
      {"images.txt", "1 0 3 0 -1 0 0 5 1 colmap.png\n\n"},
      {"cameras.txt", "1 SIMPLE_PINHOLE 200 200 100 100 100\n"},
      // Half a turn about (3, 0, -1) / sqrt(10).
      {"calibration.yml",
       "%YAML:1.0\nimage_Width: 200\nimage_Height: 200\n"
       "Camera_Matrix: {rows: 3, cols: 3, data: [100, 0, 99.5, 0, 100, 99.5, 0, 0, 1]}\n"
       "Extrinsic_Parameters: {rows: 1, cols: 6, data: [2.98037647973883, 0, -0.99345882657961, 0, 0, 5]}\n"},
  };
  const auto cameras = scene_of(dresses, beside_scene(files)).cameras;
  REQUIRE(cameras.size() == 7);
  for (const Camera& camera : cameras) {
    INFO(camera.name);
    CHECK(difference(camera, cameras[0]) <= 1e-14);
  }
}

}  // namespace sightline::tests::camera_dresses_test
