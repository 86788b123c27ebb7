#include "bench/side_by_side/view_figures.h"

#include <utility>

#include "bench/scenes/generated_scenes.h"
#include "cli/system/resources.h"
#include "sightline/analyze.h"

namespace sightline::bench {
using namespace cli;
namespace {

// The value of `work`; how long it took goes to the end of `seconds`.
template <class Stage>
auto timed(std::vector<double>& seconds, Stage stage) {
  const ProcessorTime watch;
  auto result = stage();
  seconds.push_back(watch.seconds());
  return result;
}

std::vector<double> run_stages(const BenchScene& scene, Arithmetic arithmetic) {
  const Mesh& mesh = scene.mesh;
  reset_peak();
  const std::size_t before = resident_bytes();
  std::vector<double> numbers;
  View view;
  const ProcessorTime watch;
  view.scene = timed(numbers, [&] { return project(mesh, scene.camera, scene.sides, {arithmetic}); });
  view.segments = timed(numbers, [&] { return find_visible_segments(mesh, view.scene); });
  view.polygons = timed(numbers, [&] { return reconstruct_polygons(mesh, view.scene, view.segments); });
  view.labelled = timed(numbers, [&] { return label_mesh(mesh, view.scene, view.segments, view.polygons); });
  numbers.push_back(watch.seconds());
  numbers.push_back(static_cast<double>(peak_bytes() - before) / static_cast<double>(mesh.facet_count()));
  return numbers;
}

std::vector<double> run_reflection(const MirrorWorld& world) {
  const Mesh& mesh = *world.surface;
  std::vector<double> numbers;
  const ProjectedScene scene = timed(numbers, [&] { return project(mesh, view_from_above(), Sides::both); });
  const VisibleSegments segments = timed(numbers, [&] { return find_visible_segments(mesh, scene); });
  const VisiblePolygons polygons = timed(numbers, [&] { return reconstruct_polygons(mesh, scene, segments); });
  (void)timed(numbers, [&] { return label_mesh(mesh, scene, segments, polygons); });
  const double visibility = numbers[0] + numbers[1] + numbers[2] + numbers[3];
  (void)timed(numbers, [&] { return find_reflections(world, scene, segments, polygons); });
  return {numbers.back(), visibility};
}

}  // namespace

Work view_work(const BenchScene& scene, Arithmetic arithmetic) {
  return [&scene, arithmetic] { return run_stages(scene, arithmetic); };
}

ViewFigures view_figures(const Outcome& outcome, const RunLimits& limits) {
  ViewFigures figures;
  figures.sum = figure_of(outcome, 4, limits);
  if (outcome.end != Outcome::End::done) return figures;
  figures.project = figure_of(outcome, 0, limits);
  figures.sweep = figure_of(outcome, 1, limits);
  figures.polygons = figure_of(outcome, 2, limits);
  figures.label = figure_of(outcome, 3, limits);
  figures.bytes_per_triangle = figure_of(outcome, 5, limits);
  return figures;
}

ReflectionFigures measure_reflection(std::size_t triangles, const RunLimits& limits) {
  const Mesh mesh = terrain(triangles);
  const MirrorWorld world = make_mirror_world(mesh, {{"lamp", {{-1, 9, -1}, {1, 9, -1}, {1, 9, 1}, {-1, 9, 1}}, {}}});
  const Outcome outcome = run_in_turns({[&] { return run_reflection(world); }}, limits).front();
  return {figure_of(outcome, 0, limits), figure_of(outcome, 1, limits)};
}

}  // namespace sightline::bench
