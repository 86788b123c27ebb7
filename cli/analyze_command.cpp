#include "cli/analyze_command.h"

#include <vector>

#include "cli/faces_table.h"
#include "cli/labelled_obj.h"
#include "cli/labelled_ply.h"
#include "cli/output_folder.h"
#include "cli/report.h"
#include "cli/resources.h"
#include "cli/scene_file.h"
#include "cli/segments_table.h"
#include "cli/summary.h"
#include "cli/view_analysis.h"
#include "cli/view_svg.h"
#include "cli/window_points.h"

namespace sightline {

namespace {

Scene scene_of(const AnalyzeOptions& options) {
  Scene scene = options.input_is_scene()
                    ? read_scene_file(options.input)
                    : Scene{options.input, options.input, SidesPolicy::automatic, {*options.camera}};
  scene.sides = options.sides.value_or(scene.sides);
  return scene;
}

void write_results(OutputFolder& folder, const Mesh& mesh, const View& view, const std::vector<FaceMeasures>& faces) {
  const std::vector<Point2> places = window_points(view);
  folder.write("faces.csv", faces_table(faces));
  folder.write("labelled.ply", labelled_ply(view.labelled));
  folder.write("labelled.obj", labelled_obj(view.labelled));
  folder.write("view.svg", view_svg(mesh, view, places));
  folder.write("segments.csv", segments_table(mesh, view, places));
}

// The report comes last: it says how long writing the others took.
Report written_report(const Scene& scene, const MeshInput& input, const ViewAnalysis& analysis,
                      const std::string& output) {
  const Stopwatch watch;
  OutputFolder folder(output, analysis.view.scene.camera.name);
  const std::vector<FaceMeasures> faces = measure_faces(input.mesh, analysis.view);
  write_results(folder, input.mesh, analysis.view, faces);
  const Report report = make_report(scene, input, analysis, faces, watch.seconds());
  folder.write("report.json", report_text(report));
  folder.publish();
  return report;
}

Report camera_report(const Scene& scene, const MeshInput& input, const Camera& camera, const AnalyzeOptions& options,
                     Progress& progress) {
  const ViewAnalysis analysis = analyze_view(input, camera, scene.sides, options.precision, progress);
  if (!options.output) return make_report(scene, input, analysis, measure_faces(input.mesh, analysis.view), 0);
  progress.stage(camera.name + ": write the results");
  return written_report(scene, input, analysis, *options.output);
}

std::string standard_output(const std::vector<Report>& reports, const AnalyzeOptions& options) {
  if (options.json) return report_text(reports.size() == 1 ? reports.front() : Report(reports));
  return options.quiet ? "" : summary(reports, *options.output);
}

}  // namespace

std::string analyze_command(const AnalyzeOptions& options) {
  Progress progress(!options.quiet && Progress::watched());
  const Scene scene = scene_of(options);
  const MeshInput input = read_mesh(scene.mesh_file, progress);
  std::vector<Report> reports;
  for (const Camera& camera : scene.cameras) {
    reports.push_back(camera_report(scene, input, camera, options, progress));
  }
  return standard_output(reports, options);
}

}  // namespace sightline
