#include <optional>

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
    SceneDescription scene = parse_scene(text, path);
    if (NoFiles::was_tried()) throw Finding("a file was opened");
    return scene;
  } catch (const InputError& refusal) {
    check_refusal(refusal, text, path);
    return std::nullopt;
  }
}

void check_names(const SceneDescription& scene) {
  if (scene.cameras.empty()) throw Finding("a scene without cameras");
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    const std::string& name = scene.cameras[i].name;
    if (name_defect(name)) throw Finding("a camera's name is no folder's: " + name);
    for (std::size_t j = 0; j < i; ++j) {
      if (scene.cameras[j].name == name) throw Finding("two cameras are called " + name);
    }
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
