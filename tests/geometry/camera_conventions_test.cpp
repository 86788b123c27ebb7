// Cameras in the conventions that people have: images whose y points up, affine matrices, poses from camera to world.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "geometry/numbers/errors.h"
#include "geometry/projection/camera.h"

namespace sightline::tests::camera_conventions_test {
namespace {

using Place = Eigen::Vector2d;

Place window_place(const Camera& camera, const Point3& v) {
  const Vector3 d = v - camera.origin;
  const double w = camera.projection == Projection::orthographic ? 1 : camera.forward.dot(d);
  return {camera.right.dot(d) / w, camera.up.dot(d) / w};
}

bool same_camera(const Camera& a, const Camera& b) {
  return a.right == b.right && a.up == b.up && a.forward == b.forward && a.origin == b.origin &&
         a.eye.xyz == b.eye.xyz && a.eye.w == b.eye.w && a.projection == b.projection && a.aspect == b.aspect;
}

const PixelImage image{640, 480};

PixelImage upwards(PixelImage image) {
  image.y = ImageY::up;
  return image;
}

// Pixels u = 512 X / Z + 320, v = 512 Y / Z + 240 of a camera at (0, 0, 4) that looks along -z: its y down is -y.
const Matrix34 p_down{{512, 0, -320, 1280}, {0, -512, -240, 960}, {0, 0, -1, 4}};

// The same image with rows counted from below: v becomes 480 - v.
Matrix34 turned_up(Matrix34 p) {
  p.row(1) = 480 * p.row(2) - p.row(1);
  return p;
}

}  // namespace

TEST_CASE("an image whose y points up is the same camera, where that is said") {
  const Camera down = projection_matrix_camera("p", p_down, image);
  CHECK(down.matrix_sign == 1);
  CHECK(down.forward == Vector3{0, 0, -1});
  const Matrix34 p_up = turned_up(p_down);
  const Camera up = projection_matrix_camera("p", p_up, upwards(image));
  CHECK(same_camera(up, down));
  CHECK(up.matrix_sign == 1);
  CHECK(projection_matrix_camera("p", -p_up, upwards(image)).matrix_sign == -1);
  CHECK(same_camera(projection_matrix_camera("p", -p_up, upwards(image)), down));
}

TEST_CASE("an image whose y points up, and is taken for one that points down, turns the camera, and the sign says so") {
  const Camera turned = projection_matrix_camera("p", turned_up(p_down), image);
  CHECK(turned.matrix_sign == -1);
  CHECK(turned.forward == Vector3{0, 0, 1});
}

TEST_CASE("pixel centres count from the last row, too, where y points up") {
  PixelImage centred = image;
  centred.origin = PixelOrigin::center;
  const Camera down = projection_matrix_camera("p", p_down, centred);
  Matrix34 p_up = p_down;
  p_up.row(1) = 479 * p_down.row(2) - p_down.row(1);
  CHECK(same_camera(projection_matrix_camera("p", p_up, upwards(centred)), down));
}

TEST_CASE("K has a negative second entry where y points up") {
  const Matrix3 k{{512, 0, 320}, {0, 512, 240}, {0, 0, 1}};
  const Matrix3 k_up{{512, 0, 320}, {0, -512, 240}, {0, 0, 1}};
  const Matrix3 r{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const Vector3 t{0, 0, 4};
  const Camera down = calibrated_camera("k", k, r, t, image);
  CHECK(same_camera(calibrated_camera("k", k_up, r, t, upwards(image)), down));
  CHECK_FALSE(down.matrix_sign.has_value());
  CHECK_THROWS_WITH_AS(static_cast<void>(calibrated_camera("k", k, r, t, upwards(image))),
                       doctest::Contains("second entry of K's diagonal is negative"), CameraError);
  CHECK_THROWS_WITH_AS(static_cast<void>(calibrated_camera("k", k_up, r, t, image)),
                       doctest::Contains("image_y = \"up\""), CameraError);
}

TEST_CASE("an R that is sheared, scaled or written with too few digits is refused with its defect") {
  const Matrix3 k{{512, 0, 320}, {0, 512, 240}, {0, 0, 1}};
  const auto made = [&](const Matrix3& r) { return calibrated_camera("c", k, r, {0, 0, 4}, image); };
  const Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3{1, 2, 3}.normalized()).toRotationMatrix();
  CHECK_NOTHROW(made(turn));
  CHECK_NOTHROW(made(turn.unaryExpr([](double entry) { return std::round(entry * 1e7) / 1e7; })));
  CHECK_THROWS_WITH_AS(static_cast<void>(made(turn.unaryExpr([](double e) { return std::round(e * 1e3) / 1e3; }))),
                       doctest::Contains("R is not a rotation"), CameraError);
  Matrix3 shear = Matrix3::Identity();
  shear(0, 1) = 0.25;
  CHECK_THROWS_WITH_AS(static_cast<void>(made(shear)), doctest::Contains("an entry of R R^T - 1 is 0.25"), CameraError);
  CHECK_THROWS_WITH_AS(static_cast<void>(made(2 * turn)), doctest::Contains("R R^T - 1 is 3"), CameraError);
  Matrix3 mirrored = Matrix3::Identity();
  mirrored(2, 2) = -1;
  CHECK_THROWS_WITH_AS(static_cast<void>(made(mirrored)), doctest::Contains("mirrors"), CameraError);
}

TEST_CASE("through an affine P a point goes where P puts it") {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 100; ++i) {
    Matrix34 p = Matrix34::Zero();
    for (int row : {0, 1}) {
      for (int column = 0; column < 3; ++column) p(row, column) = 100 * number(random);
      p(row, 3) = 300 * number(random);
    }
    p(2, 3) = i % 2 == 0 ? 1.5 : -0.75;
    for (const PixelOrigin origin : {PixelOrigin::corner, PixelOrigin::center}) {
      PixelImage pixels = i % 3 == 0 ? upwards(image) : image;
      pixels.origin = origin;
      const double shift = origin == PixelOrigin::center ? 0.5 : 0;
      const double sign = pixels.y == ImageY::up ? -1 : 1;
      const Camera camera = projection_matrix_camera("affine", p, pixels);
      CHECK(camera.projection == Projection::orthographic);
      const Point3 v{number(random), number(random), number(random)};
      const Vector3 h = p * v.homogeneous();
      const Place expected{2 * (h[0] / h[2] + shift) / 640 - 1, sign * (1 - 2 * (h[1] / h[2] + shift) / 480)};
      const double scale = 1 + camera.right.norm() * (camera.origin.norm() + v.norm()) + expected.norm();
      CHECK((window_place(camera, v) - expected).norm() <= 1e-13 * scale);
      // The image is not mirrored: right, up and the direction to the viewer are right-handed.
      CHECK(camera.right.cross(camera.up).dot(camera.eye.xyz) > 0);
      CHECK(std::fabs(camera.right.dot(camera.forward)) <= 1e-14 * camera.right.norm());
      CHECK(std::fabs(camera.up.dot(camera.forward)) <= 1e-14 * camera.up.norm());
    }
  }
}

TEST_CASE("an affine P of plain numbers is the orthographic camera of the same view, exactly") {
  // The window is 4 high and 16 / 3 wide; seen from +z.
  const Matrix34 p{{120, 0, 0, 320}, {0, -120, 0, 240}, {0, 0, 0, 1}};
  const Camera camera = projection_matrix_camera("affine", p, image);
  ViewPoint view;
  view.eye = {0, 0, 1};
  view.aspect = 640.0 / 480;
  const Camera same = orthographic_camera("affine", view, 4);
  CHECK(camera.right == same.right);
  CHECK(camera.up == same.up);
  CHECK(camera.forward == same.forward);
  CHECK(camera.eye.xyz == same.eye.xyz);
  CHECK(camera.eye.w == 0);
  CHECK(camera.origin == Point3{0, 0, 0});
  PixelImage with_near = image;
  with_near.near_distance = 1;
  CHECK_THROWS_WITH_AS(static_cast<void>(projection_matrix_camera("c", p, with_near)),
                       doctest::Contains("leave out near"), CameraError);
}

TEST_CASE("a pose from camera to world gives the eye as it is written, in both kinds of axes") {
  const Matrix34 opengl{{1, 0, 0, 0.1}, {0, 1, 0, 0.2}, {0, 0, 1, 4.3}};
  const Matrix34 opencv{{1, 0, 0, 0.1}, {0, -1, 0, 0.2}, {0, 0, -1, 4.3}};
  const Matrix3 k{{512, 0, 320}, {0, 512, 240}, {0, 0, 1}};
  const Camera a = posed_camera("c", k, camera_pose(opengl, CameraAxes::opengl), image);
  CHECK(same_camera(a, posed_camera("c", k, camera_pose(opencv, CameraAxes::opencv), image)));
  CHECK(a.origin == Point3{0.1, 0.2, 4.3});
  CHECK(a.forward == Vector3{0, 0, -1});
  ViewPoint view;
  view.eye = {0.1, 0.2, 4.3};
  view.direction = Vector3{0, 0, -3};
  view.aspect = 640.0 / 480;
  CHECK(same_camera(a, pinhole_camera("c", view, 480.0 / 1024)));
}

TEST_CASE("a shift moves the window by widths and heights, of rays that part and of parallel ones") {
  ViewPoint view;
  view.eye = {0, 0, 5};
  view.aspect = 2;
  for (const Camera& camera : {perspective_camera("c", view, 40), orthographic_camera("c", view, 3)}) {
    const Camera moved = shifted(camera, {0.5, -0.25});
    const Point3 v{0.3, 0.4, 0.5};
    CHECK((window_place(moved, v) - (window_place(camera, v) - Place{1, -0.5})).norm() <= 1e-15);
    CHECK(moved.forward == camera.forward);
  }
}

}  // namespace sightline::tests::camera_conventions_test
