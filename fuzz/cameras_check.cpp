#include <array>
#include <set>

#include "cli/scene/result_names.h"
#include "cli/scene/scene_file.h"
#include "fuzz/checks.h"
#include "fuzz/no_files.h"
#include "fuzz/refusal.h"

namespace sightline::fuzz {
using namespace cli;
namespace {

// The ways in which a scene file may name the bytes: plainly, with all that may be missing, as the calibration of poses.
constexpr std::array<const char*, 5> groups{
    "file = \"input\"\n",
    "file = \"input\"\nimage = [64, 48]\nlens_model = \"fisheye\"\nprefix = \"p \"\nevery = 2\n"
    "R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nt = [0, 0, 5]\n",
    "file = \"input\"\npose = \"world_to_camera\"\naxes = \"opengl\"\nfov_x_deg = 50\naspect = 1.5\nnear = 0.1\n",
    "file = \"input\"\nintrinsics = \"input\"\npose = \"camera_to_world\"\naxes = \"opencv\"\n",
    "file = \"images.txt\"\nintrinsics = \"input\"\nimage = [64, 48]\n",
};

const std::string input_file = "folder/input";

std::string text_of_file(const std::string& path, std::string_view bytes) {
  if (path == input_file) return std::string(bytes);
  if (path == "folder/images.txt") return "1 1 0 0 0 0 0 5 1 a.png\n\n2 0.5 0.5 0.5 0.5 1 2 3 1 b.png\n\n";
  throw InputError(path, 0, "the file cannot be read");
}

void check_finite(const Camera& camera) {
  for (const Vector3& v : {camera.right, camera.up, camera.forward, camera.origin, camera.eye.xyz}) {
    if (!v.allFinite()) throw Finding("camera " + camera.name + " has a number that is not finite");
  }
}

void check_all_cameras(const SceneDescription& scene) {
  std::set<std::string> names;
  for (const Camera& camera : scene.cameras) {
    if (name_defect(camera.name)) throw Finding("a camera's name is no folder's: " + camera.name);
    if (!names.insert(camera.name).second) throw Finding("two cameras are called " + camera.name);
    check_finite(camera);
  }
}

void check_group(const std::string& group, std::string_view bytes) {
  const std::string path = "folder/input.toml";
  const std::string scene = "[mesh]\nfile = \"a.obj\"\n[[cameras]]\n" + group;
  try {
    const NoFiles no_files;
    check_all_cameras(parse_scene(scene, path, [bytes](const std::string& file) { return text_of_file(file, bytes); }));
    if (NoFiles::was_tried()) throw Finding("a file was opened");
  } catch (const InputError& refusal) {
    const std::string message = refusal.what();
    const bool is_about_bytes = message.starts_with(input_file + ":");
    const bool is_about_images =
        message.starts_with("folder/images.txt:") || message.starts_with("folder/cameras.txt:");
    if (!is_about_images) check_refusal(refusal, is_about_bytes ? bytes : scene, is_about_bytes ? input_file : path);
  }
}

}  // namespace

void check_cameras(std::string_view bytes) {
  for (const char* group : groups) check_group(group, bytes);
}

}  // namespace sightline::fuzz
