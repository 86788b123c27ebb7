#include "cli/compare/compare_command.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "cli/analyze/scene_surface.h"
#include "cli/compare/compare_page.h"
#include "cli/compare/compare_table.h"
#include "cli/options/camera_options.h"
#include "cli/scene/scene_file.h"
#include "cli/system/memory_limit.h"
#include "cli/system/progress.h"
#include "cli/system/result_folders.h"
#include "peers/peer_list.h"

namespace sightline::cli {

namespace {

// The scene as the peers get it, and the truth.
struct Ground {
  ProjectedScene scene;
  peers::ExactParts exact;
};

Ground ground_of(const SceneDescription& scene, const Camera& camera, Progress& progress) {
  MeshInput input = read_surface(scene, Normals::passed_over, default_memory_limit(), progress);
  const Analyzer analyzer(std::move(input.mesh), {.sides = scene.sides, .precision = {}});
  progress.stage(camera.name + ": what is exactly visible");
  Visibility visible = analyzer.visible(camera);
  peers::ExactParts exact = peers::exact_parts(visible.scene, visible.segments, visible.polygons);
  return {std::move(visible.scene), std::move(exact)};
}

std::vector<std::optional<int>> resolutions_for(const peers::Peer& peer, const CompareOptions& options) {
  if (peer.computed_at == peers::ComputedAt::object_precision) return {std::nullopt};
  return {options.resolutions.begin(), options.resolutions.end()};
}

std::vector<CompareRun> runs_of(const Ground& ground, const peers::FlatScene& flat, const CompareOptions& options,
                                Progress& progress) {
  std::vector<CompareRun> runs;
  for (const peers::Peer& peer : peers::all_peers()) {
    if (std::find(options.peers.begin(), options.peers.end(), peer.name) == options.peers.end()) continue;
    for (const std::optional<int> resolution : resolutions_for(peer, options)) {
      progress.stage(peer.title + (resolution ? fmt::format(", {} pixels", *resolution) : ""));
      runs.push_back(run_peer(peer, flat, ground.exact, resolution, options.limit_seconds));
    }
  }
  return runs;
}

Comparison compared(const CompareOptions& options, Progress& progress) {
  const SceneDescription scene = read_scene(options.input, options.mesh_camera);
  const Camera& camera = options.camera ? camera_named(scene, *options.camera) : scene.cameras.front();
  if (camera.lens_image) {
    throw InputError(
        scene.file, 0,
        fmt::format("camera \"{}\" has a lens, which other algorithms do not have; choose one without by --camera, "
                    "or leave out its 'distortion' or 'fisheye'",
                    camera.name));
  }
  const Ground ground = ground_of(scene, camera, progress);
  const peers::FlatScene flat = peers::flat_scene(ground.scene);
  Comparison comparison{scene.file,
                        camera.name,
                        ground.scene.mesh().face_count(),
                        flat.polygons.size(),
                        ground.exact.areas.size(),
                        options.limit_seconds,
                        {}};
  comparison.runs = runs_of(ground, flat, options, progress);
  return comparison;
}

void write_results(const Comparison& comparison, const std::string& output) {
  OutputFolder folder = output_folder_at(output);
  folder.write("compare.csv", compare_table(comparison));
  folder.write("compare.json", compare_json(comparison));
  folder.write("compare.svg", compare_plot(comparison));
  folder.write("compare.html", compare_page(comparison));
  for (const CompareRun& run : comparison.runs) {
    if (!run.pictures.seen.empty()) folder.write(picture_name(run) + ".png", run.pictures.seen);
    if (!run.pictures.wrong.empty()) folder.write(picture_name(run) + "-wrong.png", run.pictures.wrong);
  }
  folder.publish();
}

std::string summary_line(const CompareRun& run) {
  const std::string error = run.areas ? fmt::format("{:.2e}", run.areas->wrong_share) : run.lines ? "lines" : "-";
  const std::string time = run.end == CompareEnd::done ? fmt::format("{:.4f}", run.seconds) : to_string(run.end);
  return fmt::format("{:22} {:>6} {:>12} {:>12}\n", run.peer.name,
                     run.resolution ? std::to_string(*run.resolution) : "", time, error);
}

std::string summary(const Comparison& comparison, const std::string& output) {
  std::string text = fmt::format("{}, camera {}: {} faces, {} of them visible\n\n{:22} {:>6} {:>12} {:>12}\n",
                                 comparison.scene, comparison.camera, comparison.faces, comparison.visible_faces,
                                 "algorithm", "pixels", "seconds", "wrong share");
  for (const CompareRun& run : comparison.runs) text += summary_line(run);
  return text + fmt::format("\nStart with {}/compare.html\n", output);
}

}  // namespace

// One thread: peers are compared by the time of one, and processes that are forked from this one have no other.
std::string compare_command(const CompareOptions& options) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
  Progress progress(!options.quiet && Progress::watched());
  const Comparison comparison = compared(options, progress);
  progress.stage("write the results");
  write_results(comparison, options.output);
  return options.quiet ? "" : summary(comparison, options.output);
}

}  // namespace sightline::cli
