#include "geometry/projection/camera.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "geometry/numbers/errors.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::camera_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Point2 window_place(const Camera& camera, const Point3& v) {
  const Vector3 d = v - camera.origin;
  const double w = camera.projection == Projection::orthographic ? 1 : camera.forward.dot(d);
  return {camera.right.dot(d) / w, camera.up.dot(d) / w};
}

void check_place(const Camera& camera, const Point3& v, const Point2& expected, double tolerance = 1e-12) {
  const Point2 place = window_place(camera, v);
  CHECK(std::abs(place.x - expected.x) <= tolerance);
  CHECK(std::abs(place.y - expected.y) <= tolerance);
}

ViewPoint from_five_on_z() {
  ViewPoint view;
  view.eye = {0, 0, 5};
  return view;
}

struct Pose {
  Matrix3 r;
  Vector3 t = Vector3::Zero();
  ViewPoint view;  // the same as eye, target and up
};

// The pose is a rotation about y by `angle`, seen from `eye`: the camera's x, y (down) and z (forward) axes are the
// rows of r.
Pose turned_pose(double angle, const Point3& eye) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Pose pose;
  pose.r << c, 0, s, 0, -1, 0, s, 0, -c;
  pose.t = -(pose.r * eye);
  pose.view.eye = eye;
  pose.view.target = eye + Vector3{s, 0, -c};
  return pose;
}

Matrix3 intrinsics(double focal, const PixelImage& image) {
  const double shift = image.origin == PixelOrigin::center ? 0.5 : 0;
  return Matrix3{{focal, 0, image.width / 2 - shift}, {0, focal, image.height / 2 - shift}, {0, 0, 1}};
}

Matrix34 product(const Matrix3& k, const Pose& pose) {
  Matrix34 p;
  p << k * pose.r, k * pose.t;
  return p;
}

// This computes by hand: it takes v to pixels through P, then to the window.
Point2 window_through(const Matrix34& p, const PixelImage& image, const Point3& v) {
  const Vector3 h = p * v.homogeneous();
  const double shift = image.origin == PixelOrigin::center ? 0.5 : 0;
  return {2 * (h[0] / h[2] + shift) / image.width - 1, 1 - 2 * (h[1] / h[2] + shift) / image.height};
}

// Returns points around a place five in front of the eye.
std::vector<Point3> points_before(const ViewPoint& view) {
  std::vector<Point3> points;
  const Point3 centre = view.eye + 5.0 * (view.target - view.eye);
  for (const double dx : {-1.0, 0.0, 1.0}) {
    for (const double dy : {-1.0, 0.25, 1.0}) {
      for (const double dz : {-1.0, 0.5}) points.push_back(centre + Vector3{dx, dy, dz});
    }
  }
  return points;
}

bool same_rows(const Camera& a, const Camera& b) {
  return a.right == b.right && a.up == b.up && a.forward == b.forward && a.origin == b.origin;
}

}  // namespace

TEST_CASE("a pinhole sees its target at the centre and the four corners of its field of view at the window's corners") {
  ViewPoint view;
  view.eye = {1, 2, 3};
  view.target = {4, -1, 7};
  view.up = {0.2, 1, -0.1};
  view.aspect = 1.5;
  const double fov = 40;
  const Camera camera = perspective_camera("front", view, fov);
  check_place(camera, view.target, {0, 0});

  const Vector3 along = view.target - view.eye;
  const Vector3 across = along.cross(view.up);
  const Vector3 upward = across.cross(along);
  const double half = norm(along) * std::tan(fov * std::numbers::pi / 360);
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Point3 corner =
          view.target + (x * half * view.aspect / norm(across)) * across + (y * half / norm(upward)) * upward;
      check_place(camera, corner, {x, y});
    }
  }
  CHECK(camera.eye.w == 1);
  CHECK(camera.eye.xyz == view.eye);
}

TEST_CASE("an axis-aligned camera with 90 degrees is exact") {
  const Camera camera = perspective_camera("front", from_five_on_z(), 90);
  CHECK(camera.right == Vector3{1, 0, 0});
  CHECK(camera.up == Vector3{0, 1, 0});
  CHECK(camera.forward == Vector3{0, 0, -1});
  CHECK(camera.origin == Point3{0, 0, 5});
}

TEST_CASE("an orthographic camera shows its height, and its eye is the given direction") {
  ViewPoint view;
  view.eye = {9, 7, 5};
  view.aspect = 2;
  const Camera camera = orthographic_camera("sun", view, 3);
  check_place(camera, view.target, {0, 0});
  check_place(camera, view.eye, {0, 0});
  const Vector3 across = (view.target - view.eye).cross(view.up);
  const Vector3 upward = across.cross(view.target - view.eye);
  check_place(camera, view.target + (3 / norm(across)) * across + (1.5 / norm(upward)) * upward, {1, 1});
  CHECK(camera.eye.w == 0);
  CHECK(camera.eye.xyz.cross(view.eye) == Vector3::Zero());
  CHECK(camera.eye.xyz.dot(view.eye) > 0);
}

TEST_CASE("through P a point goes where P puts it") {
  for (const PixelOrigin origin : {PixelOrigin::corner, PixelOrigin::center}) {
    PixelImage image;
    image.width = 1920;
    image.height = 1080;
    image.origin = origin;
    const Pose pose = turned_pose(0.3, {1, 2, 3});
    Matrix3 k = intrinsics(1500, image);
    k(0, 1) = 7;  // skew
    k(0, 2) += 31;
    const Matrix34 p = product(k, pose);
    const Camera camera = projection_matrix_camera("calibrated", p, image);
    CHECK(std::abs(norm(camera.forward) - 1) <= 1e-15);
    for (const Point3& v : points_before(pose.view)) check_place(camera, v, window_through(p, image, v));
  }
}

TEST_CASE("the same camera by K, R and t, by P and by eye and target is the same camera") {
  for (const PixelOrigin origin : {PixelOrigin::corner, PixelOrigin::center}) {
    PixelImage image;
    image.width = 640;
    image.height = 480;
    image.origin = origin;
    const double focal = 700;
    const Pose pose = turned_pose(-1.1, {-2, 0.5, 4});
    const Matrix3 k = intrinsics(focal, image);
    ViewPoint view = pose.view;
    view.aspect = image.width / image.height;
    const double fov = 2 * std::atan(image.height / 2 / focal) * 180 / std::numbers::pi;
    const std::vector<Camera> cameras = {perspective_camera("look", view, fov),
                                         calibrated_camera("krt", k, pose.r, pose.t, image),
                                         projection_matrix_camera("p", product(k, pose), image)};
    for (const Camera& camera : cameras) {
      INFO(camera.name);
      CHECK(norm(camera.right - cameras[0].right) <= 1e-12);
      CHECK(norm(camera.up - cameras[0].up) <= 1e-12);
      CHECK(norm(camera.forward - cameras[0].forward) <= 1e-12);
      CHECK(norm(camera.origin - cameras[0].origin) <= 1e-12);
      CHECK(camera.aspect == doctest::Approx(640.0 / 480));
    }
  }
}

TEST_CASE("P times any number is the same camera") {
  PixelImage image;
  image.width = 640;
  image.height = 480;
  const Matrix34 p = product(intrinsics(700, image), turned_pose(0.7, {3, 1, -2}));
  const Camera camera = projection_matrix_camera("p", p, image);
  for (const double factor : {-1.0, 0x1p-900, -0x1p900}) {
    CHECK(same_rows(projection_matrix_camera("p", factor * p, image), camera));
  }
}

TEST_CASE("the eye of P is its null vector, rounded to the nearest double") {
  const unsigned seed = 20240611;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> numerator(-1000000, 1000000);
  PixelImage image;
  image.width = 2;
  image.height = 2;
  for (int round = 0; round < 1000; ++round) {
    // diag(d) v + p4 = 0 has v = -p4 / d, one correctly rounded division.
    const std::array<double, 3> d{static_cast<double>(1 + std::abs(numerator(random))),
                                  static_cast<double>(1 + std::abs(numerator(random))),
                                  static_cast<double>(1 + std::abs(numerator(random)))};
    const std::array<double, 3> t{static_cast<double>(numerator(random)), static_cast<double>(numerator(random)),
                                  static_cast<double>(numerator(random))};
    const Matrix34 p{{d[0], 0, 0, t[0]}, {0, d[1], 0, t[1]}, {0, 0, d[2], t[2]}};
    const Camera camera = projection_matrix_camera("p", p, image);
    REQUIRE(camera.origin == Point3{-t[0] / d[0], -t[1] / d[1], -t[2] / d[2]});
  }
}

TEST_CASE("directions of any length give the same camera") {
  ViewPoint view;
  view.target = {0.3, -0.7, 0.2};
  const Camera camera = perspective_camera("c", view, 50);
  for (const double factor : {0x1p-900, 0x1p-1, 0x1p900}) {
    ViewPoint same = view;
    same.target = factor * view.target;
    same.up = factor * view.up;
    CHECK(same_rows(perspective_camera("c", same, 50), camera));
  }
  ViewPoint far_apart = view;
  far_apart.eye = -1.7e308 * view.target;
  far_apart.target = 1.7e308 * view.target;
  const Camera wide = perspective_camera("c", far_apart, 50);
  CHECK(norm(wide.forward - camera.forward) <= 1e-15);
}

TEST_CASE("up may be as close to the view direction as double can tell") {
  ViewPoint view;
  view.target = {1, 2, 3};
  view.up = {1, 2, std::nextafter(3.0, 4.0)};
  const Camera camera = perspective_camera("c", view, 50);
  CHECK(std::abs(camera.right.dot(view.target)) <= 1e-14);
  CHECK(std::abs(camera.up.dot(view.target)) <= 1e-14);
  CHECK(std::abs(camera.right.dot(camera.up)) <= 1e-14);
  check_place(camera, view.target, {0, 0});
}

TEST_CASE("a view that is none is an error that names the camera and the cause") {
  using Change = std::function<void(ViewPoint&)>;
  const std::vector<std::pair<const char*, Change>> changes = {
      {"same point", [](ViewPoint& v) { v.target = v.eye; }},
      {"up has length zero", [](ViewPoint& v) { v.up = Vector3::Zero(); }},
      {"up is along",
       [](ViewPoint& v) {
         v.up = {0, 0, -3};
       }},
      {"up is along",
       [](ViewPoint& v) {
         v.up = {0, 0, 1e-300};
       }},
      {"aspect", [](ViewPoint& v) { v.aspect = 0; }},
      {"aspect", [](ViewPoint& v) { v.aspect = -1; }},
      {"aspect", [](ViewPoint& v) { v.aspect = infinity; }},
      {"eye is not finite", [](ViewPoint& v) { v.eye.x() = not_a_number; }},
      {"target is not finite", [](ViewPoint& v) { v.target.y() = infinity; }},
      {"up is not finite", [](ViewPoint& v) { v.up.z() = -infinity; }},
      {"near is not less than far", [](ViewPoint& v) { v.near_distance = v.far_distance = 2; }},
      {"near is not finite", [](ViewPoint& v) { v.near_distance = not_a_number; }},
      {"far is not finite", [](ViewPoint& v) { v.far_distance = infinity; }},
      {"too large or too small", [](ViewPoint& v) { v.aspect = 1e-320; }},
  };
  for (const auto& entry : changes) {
    const char* cause = entry.first;
    INFO(cause);
    ViewPoint view = from_five_on_z();
    entry.second(view);
    CHECK_THROWS_WITH_AS(static_cast<void>(perspective_camera("left", view, 40)), doctest::Contains(cause),
                         CameraError);
    CHECK_THROWS_WITH_AS(static_cast<void>(orthographic_camera("left", view, 2)), doctest::Contains("camera \"left\""),
                         CameraError);
    CHECK(says_what_to_do(message_of<CameraError>([&] { static_cast<void>(perspective_camera("left", view, 40)); })));
  }
  for (const double fov : {0.0, -1.0, 180.0, 200.0, not_a_number, infinity}) {
    CHECK_THROWS_WITH_AS(static_cast<void>(perspective_camera("c", from_five_on_z(), fov)),
                         doctest::Contains("field of view"), CameraError);
  }
  for (const double height : {0.0, -2.0, not_a_number, infinity}) {
    CHECK_THROWS_WITH_AS(static_cast<void>(orthographic_camera("c", from_five_on_z(), height)),
                         doctest::Contains("orthographic height"), CameraError);
  }
}

TEST_CASE("a matrix that is no camera is an error") {
  PixelImage image;
  image.width = 640;
  image.height = 480;
  const Pose pose = turned_pose(0.2, {1, 1, 1});
  const Matrix3 k = intrinsics(500, image);
  const Matrix34 p = product(k, pose);

  const Matrix34 flat{{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 1}};
  CHECK_THROWS_WITH_AS(static_cast<void>(projection_matrix_camera("c", flat, image)), doctest::Contains("singular"),
                       CameraError);
  const Matrix34 line{{1, 2, 0, 0}, {2, 4, 0, 0}, {0, 0, 0, 1}};
  CHECK_THROWS_WITH_AS(static_cast<void>(projection_matrix_camera("c", line, image)),
                       doctest::Contains("rows are parallel"), CameraError);
  const Matrix34 nowhere{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}};
  CHECK_THROWS_WITH_AS(static_cast<void>(projection_matrix_camera("c", nowhere, image)),
                       doctest::Contains("no direction"), CameraError);
  Matrix34 with_infinity = p;
  with_infinity(1, 3) = infinity;
  CHECK_THROWS_WITH_AS(static_cast<void>(projection_matrix_camera("c", with_infinity, image)),
                       doctest::Contains("not finite"), CameraError);

  Pose mirrored = pose;
  mirrored.r.row(0) *= -1;
  CHECK_THROWS_WITH_AS(static_cast<void>(calibrated_camera("c", k, mirrored.r, mirrored.t, image)),
                       doctest::Contains("determinant"), CameraError);
  CHECK_THROWS_WITH_AS(static_cast<void>(calibrated_camera("c", Matrix3::Zero(), pose.r, pose.t, image)),
                       doctest::Contains("determinant"), CameraError);
  CHECK_THROWS_WITH_AS(static_cast<void>(calibrated_camera("c", k, pose.r, {not_a_number, 0, 0}, image)),
                       doctest::Contains("not finite"), CameraError);

  for (const double size : {0.0, -1.0, not_a_number, infinity}) {
    PixelImage wrong = image;
    wrong.width = size;
    CHECK_THROWS_WITH_AS(static_cast<void>(projection_matrix_camera("c", p, wrong)), doctest::Contains("width"),
                         CameraError);
    wrong = image;
    wrong.height = size;
    CHECK_THROWS_WITH_AS(static_cast<void>(calibrated_camera("c", k, pose.r, pose.t, wrong)),
                         doctest::Contains("height"), CameraError);
  }
  PixelImage reversed = image;
  reversed.near_distance = 3;
  reversed.far_distance = 2;
  CHECK_THROWS_WITH_AS(static_cast<void>(projection_matrix_camera("c", p, reversed)), doctest::Contains("near"),
                       CameraError);
}

}  // namespace sightline::tests::camera_test
