#include "cli/analyze/view_analysis.h"

#include "cli/analyze/memory_estimate.h"
#include "cli/system/resources.h"
#include "formats/reading/obj_reader.h"
#include "geometry/cutting/common_lines.h"

namespace sightline::cli {

namespace {

// The value of `work`, and in `seconds` how long it took.
template <class Work>
auto timed(double& seconds, Work work) {
  const Stopwatch watch;
  auto result = work();
  seconds = watch.seconds();
  return result;
}

VisibleSegments watched_sweep(const Mesh& mesh, const ProjectedScene& scene, Engine engine, Progress& progress) {
  if (!progress.shown()) return find_visible_segments(mesh, scene, engine);
  SweepProgress observer(progress, scene.points.size());
  return find_visible_segments(mesh, scene, engine, &observer);
}

}  // namespace

MeshInput read_mesh(const std::string& file, Normals normals, std::uint64_t max_memory, Progress& progress) {
  MeshInput input;
  input.max_memory = max_memory;
  progress.stage("read " + file);
  ObjFile obj = timed(input.read_seconds, [&] { return read_obj(std::filesystem::path(file), {max_memory}, normals); });
  input.mesh = std::move(obj.mesh);
  input.corner_normals = std::move(obj.corner_normals);
  input.warnings = std::move(obj.warnings);
  progress.stage("look for faces that pass through each other");
  input.contacts = timed(input.contacts_seconds, [&] { return find_contacts(input.mesh); });
  input.mesh = timed(input.cut_seconds, [&] { return cut_along_common_lines(std::move(input.mesh), input.contacts); });
  return input;
}

ViewAnalysis analyze_view(const MeshInput& input, const MirrorWorld& world, const Camera& camera,
                          const ViewOptions& options, Progress& progress) {
  const Mesh& mesh = input.mesh;
  ViewAnalysis analysis;
  StageSeconds& seconds = analysis.seconds;
  View& view = analysis.view;
  analysis.asked = options;
  progress.stage(camera.name + ": project");
  analysis.sides = timed(seconds.sides, [&] { return decide_sides(mesh, input.contacts, camera, options.sides); });
  view.scene = timed(seconds.project, [&] { return project(mesh, camera, analysis.sides.sides, options.precision); });
  require_memory_for_view(mesh, view.scene, input.max_memory);
  progress.stage(camera.name + ": sweep");
  view.segments = timed(seconds.sweep, [&] { return watched_sweep(mesh, view.scene, options.engine, progress); });
  progress.stage(camera.name + ": reconstruct the visible polygons");
  view.polygons = timed(seconds.reconstruct, [&] { return reconstruct_polygons(mesh, view.scene, view.segments); });
  const bool marks_triangles = world.options.mode == ReflectionMode::triangles;
  if (!world.panels.empty() && !marks_triangles) {
    progress.stage(camera.name + ": reflect the panels");
    ReflectedView reflected =
        timed(seconds.reflect, [&] { return find_reflections(world, view.scene, view.segments, view.polygons); });
    view.scene = std::move(reflected.scene);
    view.segments = std::move(reflected.segments);
    view.reflections = std::move(reflected.reflections);
  }
  progress.stage(camera.name + ": label the surface");
  view.labelled = timed(seconds.label, [&] {
    return label_mesh(mesh, view.scene, view.segments, view.polygons, panel_borders(view.reflections));
  });
  if (!world.panels.empty() && marks_triangles) {
    progress.stage(camera.name + ": reflect the panels");
    view.reflections = timed(seconds.reflect, [&] { return reflecting_triangles(world, camera, view.labelled); });
  }
  return analysis;
}

}  // namespace sightline::cli
