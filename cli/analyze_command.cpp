#include "cli/analyze_command.h"

#include <tbb/global_control.h>

#include <new>
#include <optional>
#include <vector>

#include "cli/analyze/normal_warnings.h"
#include "cli/analyze/scene_surface.h"
#include "cli/analyze/view_analysis.h"
#include "cli/pages/report_page.h"
#include "cli/results/region_measures.h"
#include "cli/results/report_json.h"
#include "cli/results/summary.h"
#include "cli/results/view_files.h"
#include "cli/scene/result_names.h"
#include "cli/scene/scene_file.h"
#include "cli/system/memory_limit.h"
#include "cli/system/resources.h"
#include "cli/system/result_folders.h"
#include "formats/writing/coverage_table.h"
#include "formats/writing/window_points.h"

namespace sightline::cli {

namespace {

// Each thread has so large a stack; all count against the limit of memory.
constexpr std::size_t stack_bytes = std::size_t{1} << 20;

SceneDescription scene_of(const AnalyzeOptions& options) {
  SceneDescription scene = read_scene(options.input, options.camera);
  scene.sides = options.sides.value_or(scene.sides);
  return scene;
}

// Returns the names of cameras or panels.
template <class Item>
std::vector<std::string> names_of(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

// Where the files go, and what all cameras see, for the files that are about all of them.
struct Output {
  Output(const std::string& folder, bool with_page, const MeshInput& input, const std::vector<std::string>& panels)
      : results(folder), regions(input.regions, input.of_interest, panels) {
    results.require_place_beside(coverage_file);
    results.require_place_beside(regions_file);
    if (!with_page) return;
    results.require_place_beside(report_page_file);
    page.emplace();
  }

  ResultFolders results;
  std::vector<SeenPart> seen;  // per camera
  RegionTable regions;
  std::optional<ReportPage> page;
};

// The report comes last: it says how long writing the others took.
Report written_report(const SceneDescription& scene, const MeshInput& input, const ViewAnalysis& analysis,
                      Output& output) {
  const Stopwatch watch;
  const View& view = analysis.view;
  const std::vector<FaceMeasures> faces = measure_faces(view);
  const std::vector<Point2> places = window_points(view);
  write_view_files(output.results, view, names_of(scene.panels), faces, places);
  output.regions.add_camera(view.scene.camera.name, faces);
  if (output.page) output.page->add_view(view, places, faces);
  const Report report = make_report(scene, input, analysis, faces, watch.seconds());
  output.results.write(view.scene.camera.name, "report.json", report_text(report));
  return report;
}

// output: null where no files are wanted.
Report camera_report(const SceneDescription& scene, const MeshInput& input, const ViewAnalysis& analysis,
                     Output* output, Progress& progress) {
  if (output == nullptr) return make_report(scene, input, analysis, measure_faces(analysis.view), 0);
  output->seen.push_back(seen_part(analysis.view.labelled, analysis.view.mesh()));
  progress.stage(analysis.view.scene.camera.name + ": write the results");
  return written_report(scene, input, analysis, *output);
}

Coverage published_coverage(const SceneDescription& scene, const MeshInput& input, const CutMesh& mesh,
                            const std::vector<Report>& reports, Output& output, Progress& progress) {
  progress.stage("what the cameras cover together");
  Coverage coverage = cover(mesh, output.seen, scene.panels.size(), input.of_interest);
  output.results.write_beside(coverage_file, coverage_table(coverage, names_of(scene.cameras), names_of(scene.panels)));
  output.regions.add_all_cameras(coverage);
  output.results.write_beside(regions_file, output.regions.take());
  if (output.page) output.results.write_beside(report_page_file, output.page->text(scene, mesh, reports, coverage));
  output.results.publish();
  return coverage;
}

// coverage: of what is in the folder of the results, if there is one.
std::string standard_output(const std::vector<Report>& reports, const std::optional<Coverage>& coverage,
                            const FaceRegions& regions, const AnalyzeOptions& options) {
  if (options.json)
    return reports.size() == 1 ? report_text(reports.front()) : json_text(list_json(reports, report_json));
  if (options.quiet) return "";
  return summary(reports, coverage.value(), seen_regions(regions, *coverage), *options.output, options.report_page);
}

AnalysisOptions analysis_options(const SceneDescription& scene, const AnalyzeOptions& options, MeshInput& input,
                                 AnalysisWatch& watch) {
  return {scene.sides,      options.precision,
          options.engine,   options.threads,
          scene.reflection, std::move(input.corner_normals),
          &watch,           std::move(input.mirror_faces)};
}

std::string analyzed(const AnalyzeOptions& options) {
  Progress progress(!options.quiet && Progress::watched());
  const SceneDescription scene = scene_of(options);
  const bool needs_normals = !scene.panels.empty() && scene.reflection.needs_vertex_normals();
  MeshInput input =
      read_surface(scene, needs_normals ? Normals::read : Normals::passed_over, options.max_memory, progress);
  if (needs_normals) {
    for (std::string& warning : normal_warnings(input.mesh, input.corner_normals, scene.reflection))
      input.warnings.push_back(std::move(warning));
  }
  std::optional<Output> output;
  if (options.output) output.emplace(*options.output, options.report_page, input, names_of(scene.panels));
  AnalysisWatch watch(options.max_memory, progress);
  const Analyzer analyzer(std::move(input.mesh), analysis_options(scene, options, input, watch));
  const MirrorWorld world = analyzer.world(scene.panels);
  input.doubts = surface_doubts(analyzer.mesh(), world, scene.reflection);
  for (std::string& warning : warnings_of(input.doubts, analyzer.options()))
    input.warnings.push_back(std::move(warning));
  std::vector<Report> reports;
  for (const Camera& camera : scene.cameras) {
    watch.look_at(camera.name);
    const ViewAnalysis analysis{analyzer.options(), analyzer.view(camera, world), watch.seconds()};
    reports.push_back(camera_report(scene, input, analysis, output ? &*output : nullptr, progress));
  }
  std::optional<Coverage> coverage;
  if (output) coverage = published_coverage(scene, input, analyzer.mesh(), reports, *output, progress);
  return standard_output(reports, coverage, input.regions, options);
}

}  // namespace

std::string analyze_command(const AnalyzeOptions& options) {
  hold_to(options.max_memory);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, options.threads);
  const tbb::global_control stacks(tbb::global_control::thread_stack_size, stack_bytes);
  try {
    return analyzed(options);
  } catch (const std::bad_alloc&) {
    throw MemoryError(peak_memory_bytes(), options.max_memory);
  }
}

}  // namespace sightline::cli
