#include <optional>
#include <set>

#include "cli/scene/result_names.h"
#include "cli/scene/scene_file.h"
#include "fuzz/checks.h"
#include "fuzz/no_files.h"
#include "fuzz/refusal.h"
#include "oracle/judging/judge.h"
#include "sightline/analyzer.h"

namespace sightline::fuzz {
using namespace cli;
namespace {

std::optional<SceneDescription> scene_or_refused(std::string_view text) {
  const std::string path = "folder/input.toml";
  try {
    const NoFiles no_files;
    // Every other file is a table of one camera.
    const auto table = [](const std::string& /*path*/) -> std::string {
      return "name,eye_x,eye_y,eye_z,target_x,target_y,target_z,fov_y_deg\na/b.png,0,0,5,0,0,0,40\n";
    };
    SceneDescription scene = parse_scene(text, path, table);
    if (NoFiles::was_tried()) throw Finding("a file was opened");
    return scene;
  } catch (const InputError& refusal) {
    const std::string message = refusal.what();
    if (message.starts_with(path + ":")) {
      check_refusal(refusal, text, path);
    } else if (text.find("cameras") == std::string_view::npos) {
      throw Finding("does not name its place: " + message);
    }
    return std::nullopt;
  }
}

void check_names(const SceneDescription& scene) {
  if (scene.cameras.empty()) throw Finding("a scene without cameras");
  std::set<std::string> names;
  for (const Camera& camera : scene.cameras) {
    if (name_defect(camera.name)) throw Finding("a camera's name is no folder's: " + camera.name);
    if (!names.insert(camera.name).second) throw Finding("two cameras are called " + camera.name);
  }
}

// Returns a tetrahedron around the origin with one face missing, and a square behind it.
Mesh small_mesh() {
  PolygonList faces;
  faces.push_back(std::array{VertexId(0), VertexId(1), VertexId(2)});
  faces.push_back(std::array{VertexId(0), VertexId(3), VertexId(1)});
  faces.push_back(std::array{VertexId(1), VertexId(3), VertexId(2)});
  faces.push_back(std::array{VertexId(4), VertexId(5), VertexId(6), VertexId(7)});
  return build_mesh(
      {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}, {-2, -2, -3}, {2, -2, -3}, {2, 2, -3}, {-2, 2, -3}},
      std::move(faces));
}

void check_view(const Mesh& mesh, const Camera& camera, SidesPolicy policy) {
  const auto complaints = lattice::complaints_of_stages(Analyzer(mesh, {.sides = policy}).view(camera));
  if (!complaints.empty()) throw Finding("camera " + camera.name + ": " + lattice::joined(complaints));
}

}  // namespace

void check_scene_file(std::string_view bytes) {
  const auto scene = scene_or_refused(bytes);
  if (!scene) return;
  check_names(*scene);
  const Mesh mesh = small_mesh();
  constexpr std::size_t enough = 4;
  for (std::size_t i = 0; i < std::min(enough, scene->cameras.size()); ++i) {
    check_view(mesh, scene->cameras[i], scene->sides);
  }
}

}  // namespace sightline::fuzz
