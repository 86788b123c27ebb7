// The fast engine gives what the sweep of everything gives, on every fixture and on every mesh of the optional folder
// of models.
#include <doctest/doctest.h>

#include <filesystem>

#include "cli/scene/scene_file.h"
#include "formats/reading/obj_reader.h"
#include "geometry/cutting/interpenetration.h"
#include "oracle/judging/engine_comparison.h"
#include "oracle/judging/judge.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/model_shots.h"

namespace sightline::tests::engine_meshes_test {
using namespace cli;
using namespace lattice;

namespace {

bool is_scene(const std::filesystem::path& file) {
  return file.extension() == ".toml" && file.string().find("bad-") == std::string::npos;
}

}  // namespace

TEST_CASE("engines: fixtures") {
  std::size_t views = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SIGHTLINE_FIXTURES_DIR)) {
    if (!is_scene(entry.path())) continue;
    const SceneDescription scene = read_scene_file(entry.path().string());
    const Mesh whole = read_obj(std::filesystem::path(scene.mesh_file)).mesh;
    const MeshContacts contacts = find_contacts(whole);
    const CutMesh mesh = cut(whole);
    for (const Camera& camera : scene.cameras) {
      INFO(entry.path().string(), " ", camera.name);
      EngineTally tally;
      const Sides sides = decide_sides(mesh, contacts, camera, scene.sides).sides;
      CHECK(engine_differences(project(mesh, camera, sides), {{2, 1}, {4, 2}, {7, 7}, {5, 64}}, tally) == "");
      ++views;
    }
  }
  CHECK(views >= 30);
}

TEST_CASE("engines: models") {
  for (const std::filesystem::path& file : models()) {
    const Mesh whole = read_obj(file).mesh;
    const CutMesh mesh = cut(whole);
    for (const Shot& shot : shots(whole)) {
      INFO(file.filename().string(), " ", shot.camera.name);
      EngineTally tally;
      CHECK(engine_differences(project(mesh, shot.camera, shot.sides), {{4, 1}, {7, 7}, {8, 64}, {10, 2}}, tally) ==
            "");
      MESSAGE(file.filename().string() << " " << shot.camera.name << ": " << tally.swept << " of " << tally.points
                                       << " sweep points swept");
    }
  }
}

}  // namespace sightline::tests::engine_meshes_test
