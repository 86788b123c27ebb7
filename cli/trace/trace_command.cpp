#include "cli/trace/trace_command.h"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>

#include "cli/analyze/scene_surface.h"
#include "cli/options/camera_options.h"
#include "cli/options/requests.h"
#include "cli/pages/page_template.h"
#include "cli/scene/scene_file.h"
#include "cli/system/durable_file.h"
#include "cli/system/memory_limit.h"
#include "cli/system/result_folders.h"
#include "cli/trace/sweep_log_json.h"
#include "cli/trace/trace_examples.h"
#include "geometry/projection/culling.h"
#include "trace/trace_sweep.h"

namespace sightline::cli {

namespace {

// Everything that a sweep depends on but for its precision.
struct Traced {
  std::string file;  // for messages
  std::string title;
  std::string what;
  trace::TracedView view;
};

std::string list_of_examples() {
  std::string text;
  for (const TraceExample& example : trace_examples())
    text += fmt::format("{:<18}{}: {}\n", example.name, example.title, example.what);
  return text;
}

Traced of_scene_file(const TraceOptions& options) {
  const SceneDescription scene = read_scene_file(*options.input);
  const Camera& camera = options.camera ? camera_named(scene, *options.camera) : only_camera(scene);
  if (camera.lens_image) {
    throw InputError(scene.file, 0,
                     fmt::format("camera '{}' has a lens, whose frame has too many sides to be followed; leave "
                                 "'distortion' or 'fisheye' out",
                                 camera.name));
  }
  Progress silent(false);
  MeshInput input = read_surface(scene, Normals::passed_over, default_memory_limit(), silent);
  const Analyzer analyzer(std::move(input.mesh), {.sides = options.sides.value_or(scene.sides), .precision = {}});
  return {scene.file, scene.file, "", {analyzer.shared_mesh(), camera, analyzer.sides(camera).sides, {}, {}}};
}

Traced of_example(const std::string& name) {
  const TraceExample& example = *trace_example_named(name);
  TraceScene scene = example.make();
  return {example.name,
          example.title,
          example.what,
          {std::make_shared<const CutMesh>(std::move(scene.mesh)), scene.camera, Sides::both, scene.precision,
           std::move(scene.names)}};
}

// Points that are in view and crossings: what a smaller view has fewer of.
trace::SweepLog log_of(const Traced& traced, const Precision& precision) {
  trace::TracedView view = traced.view;
  view.precision = precision;
  try {
    return trace::trace_sweep(view);
  } catch (const trace::TooManySteps& error) {
    throw InputError(traced.file, 0,
                     fmt::format("camera '{}' has {} points in view, and with the crossings of their edges more than "
                                 "the {} sweep points that a trace has room for; crop: give a camera a narrower fov_y "
                                 "(or a smaller orthographic_height), or take a smaller mesh",
                                 view.camera.name, error.points_in_view(), trace::most_traced_points));
  }
}

std::vector<trace::SweepLog> logs_of(const Traced& traced, const Precision& precision) {
  std::vector<trace::SweepLog> logs;
  try {
    logs.push_back(log_of(traced, precision));
  } catch (const ArithmeticError& error) {
    throw InputError(traced.file, 0, error.what());
  }
  if (precision.arithmetic != Arithmetic::exact)
    logs.push_back(log_of(traced, {Arithmetic::exact, precision.grid_bits}));
  return logs;
}

// It appears at once (result_folders.h), in a folder that is there.
void write_file(const std::string& path, std::string_view content) {
  const std::filesystem::path place = std::filesystem::absolute(path);
  std::error_code ignored;
  if (!std::filesystem::is_directory(place.parent_path(), ignored)) fail_to_write(place, ENOENT);
  ResultFolders results(place.parent_path());
  results.write_beside(place.filename().string(), content);
  results.publish();
}

std::string summary_of(const std::vector<trace::SweepLog>& logs, const TraceOptions& options) {
  std::string text;
  for (const trace::SweepLog& log : logs)
    text +=
        fmt::format("{}: {} sweep points, {} visible segments{}\n", to_string(log.scene.arithmetic), log.steps.size(),
                    log.segments.size(), log.broken.empty() ? "" : "; ended early: " + log.broken);
  for (const auto& file : {options.output, options.log}) {
    if (file) text += *file + "\n";
  }
  return text;
}

}  // namespace

std::string trace_command(const TraceOptions& options) {
  if (options.list) return list_of_examples();
  if (options.output) require_page(PageName::trace);
  const Traced traced = options.example ? of_example(*options.example) : of_scene_file(options);
  const std::vector<trace::SweepLog> logs = logs_of(traced, options.precision.value_or(traced.view.precision));
  const std::string json = json_text(
      sweep_logs_json({traced.title, traced.what, traced.view.camera.name, traced.view.camera.aspect}, logs), 1);
  if (options.log) write_file(*options.log, json);
  if (options.output) write_file(*options.output, page_with_data(PageName::trace, packed(json)));
  return summary_of(logs, options);
}

}  // namespace sightline::cli
