// The keys of a scene file that say a camera's lens.
#include "cli/scene/lens_keys.h"

#include <doctest/doctest.h>

#include <string>

#include "cli/scene/scene_file.h"
#include "geometry/numbers/errors.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::lens_keys_test {
namespace {

// The keys begin in line 9.
cli::SceneDescription scene_with(const std::string& keys) {
  return cli::parse_scene(
      "[mesh]\nfile = \"a.obj\"\n[[camera]]\nname = \"krt\"\nK = [[1000, 0, 960], [0, 1000, 540], [0, 0, 1]]\n"
      "R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nt = [0, 0, 5]\nimage = [1920, 1080]\n" +
          keys,
      "dir/scene.toml");
}

Camera camera_with(const std::string& keys) { return scene_with(keys).cameras.front(); }

void check_refused(const std::string& keys, const std::string& says) {
  INFO(keys);
  try {
    static_cast<void>(scene_with(keys));
    FAIL_CHECK("the scene was accepted");
  } catch (const InputError& error) {
    const std::string what = error.what();
    INFO(what);
    CHECK(what.find(says) != std::string::npos);
    CHECK(says_what_to_do(what));
    CHECK(what.rfind("dir/scene.toml:", 0) == 0);
  }
}

}  // namespace

TEST_CASE("A scene file gives a lens in OpenCV's order") {
  const Lens five = camera_with("distortion = [-0.11, 0.02, 0.003, 0.004, 0.005]\n").lens_image.value().lens;
  CHECK(five.model == LensModel::brown);
  CHECK(five.radial == std::array{-0.11, 0.02, 0.005, 0.0, 0.0, 0.0});
  CHECK(five.tangential == std::array{0.003, 0.004});
  const Lens eight =
      camera_with("distortion = [-0.1, 0.02, 0.003, 0.004, 0.005, 0.006, 0.007, 0.008]\n").lens_image.value().lens;
  CHECK(eight.radial == std::array{-0.1, 0.02, 0.005, 0.006, 0.007, 0.008});
  const Camera wide = camera_with("fisheye = [-0.01, 0.02, 0.003, 0]\nframe_tolerance = 0.5\n");
  CHECK(wide.lens_image.value().lens.model == LensModel::fisheye);
  CHECK(wide.lens_image.value().lens.radial == std::array{-0.01, 0.02, 0.003, 0.0, 0.0, 0.0});
  CHECK(wide.lens_image.value().frame_tolerance == 0.5);
}

TEST_CASE("Coefficients of zero are no lens") {
  const Camera without = camera_with("");
  const Camera with = camera_with("distortion = [0, 0, 0, 0, 0]\n");
  CHECK(!with.lens_image);
  CHECK(with.right == without.right);
  CHECK(with.up == without.up);
  CHECK(with.origin == without.origin);
  CHECK(with.aspect == without.aspect);
}

TEST_CASE("A wrong lens is refused with file, line, and what to do") {
  check_refused("distortion = [1, 2, 3]\n",
                "scene.toml:9: 'distortion' has 3 numbers; give k1, k2, p1, p2, or these and k3");
  check_refused("distortion = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\n", "has 12 numbers; thin prisms");
  check_refused("distortion = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]\n", "calibrate without them, to 8 numbers");
  check_refused("distortion = 0.1\n", "'distortion' must be of the form [number, ...]");
  check_refused("distortion = [\"k1\", 0, 0, 0]\n", "must be made of numbers");
  check_refused("fisheye = [0.1]\n", "give k1, k2, k3, k4, with 0 for what is missing");
  check_refused("fisheye = [0, 0, 0, 0]\ndistortion = [0, 0, 0, 0]\n", "give one of them");
  check_refused("frame_tolerance = 0.1\n", "is for cameras with a lens");
  check_refused("distortion = [-0.1, 0, 0, 0]\nframe_tolerance = -1\n", "0.01 pixels is usual");
  check_refused("distortion = [-2, 0, 0, 0]\n", "the lens model folds at r = 0.4082, 22.21 degrees off the axis");
}

}  // namespace sightline::tests::lens_keys_test
