// The labelled surface where nothing is rounded: it conforms, covers every face, and has no more visible than in view, on
// scenes where coincidences abound, on scenes beside them by single last bits, and on real meshes that pass through themselves.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "cli/results/face_measures.h"
#include "cli/scene/scene_file.h"
#include "formats/reading/obj_reader.h"
#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_scenes.h"
#include "sightline/analyzer.h"
#include "tests/tools/model_shots.h"
#include "tests/tools/polygon_mesh.h"
#include "tests/tools/unrounded_scenes.h"

namespace sightline::tests::unrounded_labels_test {
namespace {

View unrounded(Mesh mesh, const Camera& camera, Sides sides, Engine engine = Engine::fast) {
  const AnalysisOptions options{.sides = policy_of(sides), .precision = {Arithmetic::unrounded}, .engine = engine};
  return Analyzer(std::move(mesh), options).view(camera);
}

void check_valid(const View& view) {
  for (const std::string& complaint : lattice::complaints_of_stages(view)) FAIL_CHECK(complaint);
}

void check_measures(const View& view) {
  for (const cli::FaceMeasures& face : cli::measure_faces(view)) {
    CHECK(face.visible_area <= face.in_view_area);
    CHECK(face.in_view_area <= face.area);
  }
}

}  // namespace

TEST_CASE("without rounding the labelled surfaces of random scenes conform and are covered") {
  const std::uint64_t scenes = lattice::scene_count(3000) / 3;
  std::size_t swaps = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    CAPTURE(seed);
    const lattice::RandomScene scene = seed % 2 == 0 ? lattice::random_scene(seed) : lattice::crossing_scene(seed);
    for (const Moved how : every_move) {
      CAPTURE(static_cast<int>(how));
      const View view = unrounded(moved(scene, how), scene.camera, scene.sides);
      check_valid(view);
      check_measures(view);
      swaps += view.segments.swap_edges.size();
    }
  }
  CHECK(swaps > scenes);
}

TEST_CASE("without rounding the labelled surfaces of soups on a few points conform and are covered") {
  for (std::uint64_t seed = 1; seed <= lattice::scene_count(3000) / 3; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const Mesh mesh = few_points_soup(random);
    const View view = unrounded(mesh, on_grid_camera(random), Sides::both);
    check_valid(view);
    check_measures(view);
  }
}

TEST_CASE("without rounding, labelled surfaces of scenes that are nearly degenerate are valid") {
  for (const std::filesystem::path& file : near_degenerate_scenes()) {
    CAPTURE(file.string());
    const cli::SceneDescription scene = cli::read_scene_file(file.string());
    for (const Camera& camera : scene.cameras) {
      const View view = unrounded(read_obj(scene.mesh_file).mesh, camera, Sides::both);
      check_valid(view);
      check_measures(view);
    }
  }
}

TEST_CASE("without rounding and without cutting, the labelled surfaces of real meshes are valid") {
  for (const std::filesystem::path& file : models()) {
    CAPTURE(file.filename().string());
    Mesh mesh = read_obj(file).mesh;
    if (mesh.facet_count() > 20000) continue;
    const Shot shot = shots(mesh).front();
    const View view = unrounded(std::move(mesh), shot.camera, shot.sides);
    check_valid(view);
    check_measures(view);
  }
}

}  // namespace sightline::tests::unrounded_labels_test
