// Keys of cameras beside the plain ones, and rigs of cameras.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/numbers/errors.h"
#include "tests/tools/says_what_to_do.h"
#include "tests/tools/scene_texts.h"

namespace sightline::tests::camera_groups_test {
namespace {

std::vector<Camera> cameras_of(const std::string& text) { return scene_of(text, {}).cameras; }

Camera camera_with(const std::string& keys) { return cameras_of("[[camera]]\nname = \"c\"\n" + keys).front(); }

const std::string look = "eye = [0, 0, 5]\ntarget = [0, 0, 0]\n";
const std::string matrix = "camera_to_world = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 5]]\n";

void check_refused(const std::string& text, std::size_t line, const std::string& says) {
  INFO(text);
  try {
    static_cast<void>(cameras_of(text));
    FAIL_CHECK("the scene was accepted");
  } catch (const InputError& error) {
    const std::string what = error.what();
    INFO(what);
    CHECK(error.line() == line);
    CHECK(what.find(says) != std::string::npos);
    CHECK(says_what_to_do(what));
  }
}

}  // namespace

TEST_CASE("a horizontal angle, a focal length and a shift make the window") {
  const Camera wide = camera_with(look + "fov_x_deg = 90\naspect = 2\n");
  CHECK(wide.right == Vector3{1, 0, 0});
  CHECK(wide.up == Vector3{0, 2, 0});
  const Camera lens = camera_with(look + "focal_length_mm = 36\nsensor_mm = [36, 24]\n");
  CHECK(lens.right == Vector3{2, 0, 0});
  CHECK(lens.up == Vector3{0, 3, 0});
  CHECK(lens.aspect == 1.5);
  const Camera moved = camera_with(look + "fov_x_deg = 90\nshift = [0.5, -0.25]\n");
  CHECK(moved.right == Vector3{1, 0, 1});
  CHECK(moved.up == Vector3{0, 1, -0.5});
  CHECK(camera_with(matrix + "axes = \"opengl\"\northographic_height = 4\nnear = 1\n").forward == Vector3{0, 0, -1});
}

TEST_CASE("keys that do not go together are refused") {
  const std::string head = "[[camera]]\nname = \"c\"\n";
  check_refused(head + look + "fov_x_deg = 40\nfov_y_deg = 40\n", 7, "give exactly one");
  check_refused(head + look + "fov_x_deg = 190\n", 3, "horizontal field of view");
  check_refused(head + look + "focal_length_mm = 36\n", 3, "has no 'sensor_mm'");
  check_refused(head + look + "focal_length_mm = 36\nsensor_mm = [36, 24]\naspect = 2\n", 9, "leave out 'aspect'");
  check_refused(head + look + "fov_y_deg = 40\nsensor_mm = [36, 24]\n", 8, "goes with 'focal_length_mm'");
  check_refused(head + look + "fov_y_deg = 40\naxes = \"opengl\"\n", 8, "goes with 'camera_to_world'");
  check_refused(head + matrix + "fov_y_deg = 40\n", 5, "needs axes");
  check_refused(head + matrix + look + "axes = \"opengl\"\nfov_y_deg = 40\n", 6, "both 'camera_to_world' and 'eye'");
  check_refused(head + "camera_to_world = [[1, 0, 0, 0]]\naxes = \"opengl\"\nfov_y_deg = 40\n", 5, "3 or 4 rows of 4");
  check_refused(
      head + "camera_to_world = [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 5]]\naxes = \"opengl\"\nfov_y_deg = 40\n", 3,
      "R is not a rotation");
  check_refused(head + "P = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]\nimage = [2, 2]\nimage_y = \"left\"\n", 7,
                "'image_y' must be");
}

TEST_CASE("a ring goes around its axis evenly, and quarters of a turn are exact") {
  const auto ring = cameras_of("[[cameras]]\nring = { number = 4, radius = 5, center = [1, 2, 3] }\nfov_y_deg = 90\n");
  REQUIRE(ring.size() == 4);
  CHECK(ring[0].name == "ring-01");
  CHECK(ring[0].origin == Point3{1, 2, 8});
  CHECK(ring[1].origin == Point3{6, 2, 3});
  CHECK(ring[2].origin == Point3{1, 2, -2});
  CHECK(ring[3].origin == Point3{-4, 2, 3});
  for (const Camera& camera : ring) CHECK(camera.up == Vector3{0, 1, 0});
  const auto raised = cameras_of(
      "[[cameras]]\nring = { number = 100, radius = 2, height = 1, axis = [0, 0, 2], start = [0, 3, 1] }\n"
      "prefix = \"r \"\nfov_y_deg = 40\n");
  CHECK(raised[0].origin == Point3{0, 2, 1});
  CHECK(raised[99].name == "r ring-100");
  for (std::size_t i = 0; i < raised.size(); ++i) {
    CHECK(raised[i].origin.z() == 1);
    CHECK(std::fabs(raised[i].origin.head<2>().norm() - 2) <= 1e-15);
    const double step = (raised[i].origin - raised[(i + 1) % 100].origin).norm();
    CHECK(std::fabs(step - 4 * std::sin(std::acos(-1) / 100)) <= 1e-14);
    CHECK((raised[i].forward + raised[i].origin.normalized()).norm() <= 1e-15);
  }
}

TEST_CASE("a sphere has its cameras all over it, at some distance from each other") {
  const auto sphere = cameras_of(
      "[[cameras]]\nsphere = { number = 200, radius = 3, center = [0, 0, 1] }\nfov_y_deg = 40\nnear = 1\nfar = 9\n");
  REQUIRE(sphere.size() == 200);
  Vector3 sum = Vector3::Zero();
  double nearest = 6;
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    CHECK(std::fabs((sphere[i].origin - Point3{0, 0, 1}).norm() - 3) <= 1e-14);
    CHECK(sphere[i].far_distance == 9.0);
    sum += sphere[i].origin - Point3{0, 0, 1};
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (sphere[i].origin - sphere[j].origin).norm());
  }
  CHECK(sum.norm() / 200 <= 0.02);
  // Discs of that diameter, evenly packed, would cover most of the sphere: 4 pi 9 / 200 is the area of each.
  CHECK(nearest >= 0.75 * std::sqrt(4 * std::acos(-1) * 9 / 200));
  CHECK(cameras_of("[[cameras]]\nsphere = { number = 1, radius = 3 }\nfov_y_deg = 40\n")[0].origin == Point3{0, 0, 3});
}

TEST_CASE("a grid is across the view, from the top left, and its cameras look in one direction") {
  const auto grid = cameras_of(
      "[[cameras]]\ngrid = { number = [3, 2], size = [4, 1], center = [0, 0, 5], target = [0, 0, 0] }\n"
      "orthographic_height = 2\n");
  REQUIRE(grid.size() == 6);
  CHECK(grid[0].name == "grid-01-01");
  CHECK(grid[5].name == "grid-02-03");
  CHECK(grid[0].origin == Point3{-2, 0.5, 5});
  CHECK(grid[1].origin == Point3{0, 0.5, 5});
  CHECK(grid[5].origin == Point3{2, -0.5, 5});
  for (const Camera& camera : grid) CHECK(camera.forward == Vector3{0, 0, -1});
}

TEST_CASE("rigs and groups that are none are refused") {
  const std::string head = "[[cameras]]\n";
  check_refused("[cameras]\nfile = \"a\"\n", 3, "must be an array of tables: [[cameras]]");
  check_refused(head, 3, "none of file, ring, sphere, grid");
  check_refused(head + "ring = 1\nfov_y_deg = 40\n", 4, "'ring' must be a table");
  check_refused(head + "ring = { number = 4, radius = 1 }\n", 3, "none of fov_y_deg");
  check_refused(head + "ring = { number = 0, radius = 1 }\nfov_y_deg = 40\n", 4, "whole number from 1 to 100000");
  check_refused(head + "ring = { number = 4.5, radius = 1 }\nfov_y_deg = 40\n", 4, "whole number");
  check_refused(head + "ring = { number = 4, radius = 0 }\nfov_y_deg = 40\n", 4, "'radius' must be positive");
  check_refused(head + "ring = { number = 4, radius = 1, axis = [0, 0, 0] }\nfov_y_deg = 40\n", 3, "length zero");
  check_refused(head + "ring = { number = 4, radius = 1, start = [0, 1, 0] }\nfov_y_deg = 40\n", 3, "along its axis");
  check_refused(head + "ring = { number = 4, radius = 1 }\nfile = \"a\"\n", 4, "both 'file' and 'ring'");
  check_refused(head + "ring = { number = 4, radius = 1, colour = 1 }\nfov_y_deg = 40\n", 4, "unknown key 'colour'");
  check_refused(head +
                    "grid = { number = [1000, 1000], size = [1, 1], center = [0, 0, 1], target = [0, 0, 0] }\n"
                    "fov_y_deg = 40\n",
                4, "more than 100000 cameras");
  check_refused(head + "file = \"absent.yml\"\n", 0, "cannot be read");
  const std::string ring = head + "ring = { number = 2, radius = 1 }\nfov_y_deg = 40\n";
  check_refused(ring + ring, 6, "a second camera is called \"ring-01\"; set another prefix");
}

}  // namespace sightline::tests::camera_groups_test
