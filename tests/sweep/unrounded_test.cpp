// The sweep without rounding sees exactly what the truth in rationals sees: on random scenes of a lattice, where coincidences
// abound, on such scenes moved off the lattice, and on scenes that pass through themselves, uncut.
#include "sweep/unrounded/unrounded_sweep.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "cli/scene/scene_file.h"
#include "formats/reading/obj_reader.h"
#include "geometry/cutting/common_lines.h"
#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_scenes.h"
#include "oracle/truth/truth.h"
#include "reconstruct/polygons/visible_polygons.h"
#include "sweep/plain/sweep.h"
#include "sweep/segments/image_points.h"
#include "tests/tools/model_shots.h"
#include "tests/tools/polygon_mesh.h"
#include "tests/tools/unrounded_areas.h"
#include "tests/tools/unrounded_scenes.h"

namespace sightline::tests::unrounded_test {
namespace {

using lattice::RandomScene;

constexpr std::uint64_t first_seed = 1;

struct Tally {
  std::size_t scenes = 0;
  std::size_t along_swaps = 0;
  std::uint64_t exact_sides = 0;
};

void hold_to_truth(const Mesh& mesh, const Camera& camera, Sides sides, Tally& tally) {
  const UnroundedAreas seen = unrounded_areas(mesh, camera, sides);
  const oracle::Truth truth = oracle::true_visibility(mesh, camera, sides);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) CHECK(seen.of_face[f] == truth.visible_area[f]);
  ++tally.scenes;
  tally.along_swaps += seen.along_swaps;
  tally.exact_sides += seen.counts.exact_sides;
}

// Per face the area in the window, as doubles have it.
std::vector<double> window_areas(const CutMesh& mesh, const VisibleSegments& segments, const auto& in_window) {
  std::vector<double> areas(mesh.face_count(), 0);
  for (const VisibleSegment& s : segments.segments) {
    const auto [ax, ay] = in_window(s.start);
    const auto [bx, by] = in_window(s.end);
    areas[mesh.facet_face[s.facet.index()].index()] += (ax * by - ay * bx) / 2;
  }
  return areas;
}

std::vector<double> areas_without_rounding(const Mesh& mesh, const Shot& shot) {
  const UnroundedView view = unrounded_view(mesh, shot.camera, shot.sides);
  const ImagePoints points(view.scene, view.segments);
  return window_areas(view.scene.mesh(), view.segments, [&](PointId p) {
    const CertifiedPlace place = points.certified(p);
    return std::array{place.x, place.y};
  });
}

std::vector<double> areas_on_grid(const Mesh& mesh, const Shot& shot) {
  const CutMesh cut = cut_along_common_lines(mesh, find_contacts(mesh));
  const ProjectedScene scene = project(cut, shot.camera, shot.sides);
  const VisibleSegments found = plain_sweep(scene);
  const ImagePoints points(scene, found);
  return window_areas(cut, found, [&](PointId p) {
    const Point2 place = points.approximate(p);
    return std::array{std::ldexp(place.x, -scene.grid_bits), std::ldexp(place.y, -scene.grid_bits)};
  });
}

// Of a face seen in so many points, each off by a spacing, no more than this can be wrong.
constexpr double largest_difference = 1e-8;

}  // namespace

TEST_CASE("without rounding the visible areas are the truth's, as rationals") {
  const std::uint64_t scenes = lattice::scene_count(3000) / 10;
  Tally plain;
  Tally crossing;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    for (const Moved how : every_move) {
      CAPTURE(seed);
      CAPTURE(static_cast<int>(how));
      const RandomScene apart = lattice::random_scene(seed);
      hold_to_truth(moved(apart, how), apart.camera, apart.sides, plain);
      const RandomScene through = lattice::crossing_scene(seed);
      hold_to_truth(moved(through, how), through.camera, through.sides, crossing);
    }
  }
  MESSAGE(plain.scenes << " scenes, " << plain.exact_sides << " sides decided in integers; " << crossing.scenes
                       << " that pass through themselves, " << crossing.along_swaps << " segments along swap edges, "
                       << crossing.exact_sides << " sides in integers");
  CHECK(plain.exact_sides > plain.scenes);
  CHECK(crossing.along_swaps > crossing.scenes);
}

TEST_CASE("without rounding and without cutting, real meshes show what they show cut and rounded") {
  std::size_t compared = 0;
  for (const std::filesystem::path& file : models()) {
    CAPTURE(file.filename().string());
    const Mesh mesh = read_obj(file).mesh;
    if (mesh.facet_count() > 20000) continue;
    const Shot shot = shots(mesh).front();
    const std::vector<double> unrounded = areas_without_rounding(mesh, shot);
    const std::vector<double> rounded = areas_on_grid(mesh, shot);
    double worst = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) worst = std::max(worst, std::fabs(unrounded[f] - rounded[f]));
    CHECK(worst < largest_difference);
    ++compared;
  }
  MESSAGE(compared << " models");
}

TEST_CASE("without rounding the visible areas of soups on a few points are the truth's, as rationals") {
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + lattice::scene_count(3000) / 3; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const Mesh mesh = few_points_soup(random);
    hold_to_truth(mesh, on_grid_camera(random), seed % 5 == 0 ? Sides::front : Sides::both, tally);
  }
  MESSAGE(tally.scenes << " scenes, " << tally.along_swaps << " segments along swap edges, " << tally.exact_sides
                       << " sides in integers");
  CHECK(tally.along_swaps > tally.scenes);
  CHECK(tally.exact_sides > 5 * tally.scenes);
}

TEST_CASE("without rounding the visible areas of scenes at the extremes of numbers are the truth's, as rationals") {
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + lattice::scene_count(1000); ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    hold_to_truth(extreme_soup(random), camera_in_origin(), seed % 5 == 0 ? Sides::front : Sides::both, tally);
  }
  MESSAGE(tally.scenes << " scenes, " << tally.along_swaps << " segments along swap edges, " << tally.exact_sides
                       << " sides in integers");
  CHECK(tally.along_swaps > tally.scenes);
  CHECK(tally.exact_sides > tally.scenes / 10);
}

// Of each face the areas of its polygons are within their own rounding of what the segments bound, exactly; and there are as
// many polygons and rings as on the grid, of what is cut there, where nothing passes through anything.
TEST_CASE("without rounding the visible polygons have the areas that their segments bound") {
  const std::uint64_t scenes = lattice::scene_count(1000);
  std::size_t holes = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    CAPTURE(seed);
    const RandomScene random = seed % 2 == 0 ? lattice::random_scene(seed) : lattice::crossing_scene(seed);
    const Mesh mesh = mesh_of(random);
    const UnroundedView view = unrounded_view(mesh, random.camera, random.sides);
    const VisiblePolygons polygons = reconstruct_polygons(view.scene, view.segments);
    std::vector<double> areas(mesh.face_count(), 0);
    for (const VisiblePolygon& p : polygons.polygons) areas[p.face.index()] += p.area;
    const UnroundedAreas exact = unrounded_areas(mesh, random.camera, random.sides);
    for (std::size_t f = 0; f < areas.size(); ++f)
      CHECK(std::fabs(areas[f] - exact.of_face[f].convert_to<double>()) <= 1e-13);
    if (seed % 2 == 0) {
      const ProjectedScene on_grid = project(uncrossed(mesh), random.camera, random.sides);
      const VisiblePolygons expected = reconstruct_polygons(on_grid, plain_sweep(on_grid));
      CHECK(polygons.polygons.size() == expected.polygons.size());
      CHECK(polygons.ring_count() == expected.ring_count());
    }
    holes += polygons.ring_count() - polygons.polygons.size();
  }
  CHECK(100 * holes > scenes);
}

// These two ramps cross beside the camera: in front of it one hides the other, behind it the other way round, and their planes
// meet in the camera's own plane, which its image does not show.
TEST_CASE("without rounding, facets that change places beside the camera only have one order in view") {
  const Mesh mesh = mesh_of({{{-8, -2, -8}, {8, -2, -8}, {0, 0, 8}}, {{-8, 0, -8}, {8, 0, -8}, {0, -2, 8}}});
  ViewPoint view;
  view.eye = {0, 0, 0};
  view.target = {0, 0, -1};
  const Camera camera = perspective_camera("between", view, 90);
  Tally tally;
  hold_to_truth(mesh, camera, Sides::both, tally);
  CHECK(tally.along_swaps == 0);
}

// These scenes lose or gain whole faces where places are rounded.
TEST_CASE("without rounding, faces that are nearly degenerate show their true areas") {
  for (const std::filesystem::path& file : near_degenerate_scenes()) {
    CAPTURE(file.string());
    const cli::SceneDescription scene = cli::read_scene_file(file.string());
    const Mesh mesh = read_obj(scene.mesh_file).mesh;
    for (const Camera& camera : scene.cameras) {
      const UnroundedAreas seen = unrounded_areas(mesh, camera, Sides::both);
      const oracle::Truth truth = oracle::true_visibility(mesh, camera, Sides::both);
      for (std::size_t f = 0; f < mesh.face_count(); ++f) CHECK(seen.of_face[f] == truth.visible_area[f]);
    }
  }
}

}  // namespace sightline::tests::unrounded_test
