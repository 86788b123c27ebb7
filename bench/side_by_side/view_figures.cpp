#include "bench/side_by_side/view_figures.h"

#include <utility>

#include "bench/scenes/generated_scenes.h"
#include "cli/system/resources.h"
#include "sightline/analyzer.h"

namespace sightline::bench {
using namespace cli;
namespace {

// How long the stages of a view take, in their order; deciding on the sides is none where they are given.
class StageTimes : public AnalysisHook {
 public:
  void begins(Stage /*stage*/) override { watch_ = ProcessorTime(); }
  void ended(Stage stage, double /*seconds*/) override {
    if (stage != Stage::sides) seconds_.push_back(watch_.seconds());
  }
  [[nodiscard]] const std::vector<double>& seconds() const { return seconds_; }

 private:
  ProcessorTime watch_;
  std::vector<double> seconds_;
};

std::vector<double> run_stages(const BenchScene& scene, Arithmetic arithmetic) {
  reset_peak();
  const std::size_t before = resident_bytes();
  StageTimes times;
  const Analyzer analyzer(scene.mesh, {.sides = policy_of(scene.sides), .precision = {arithmetic}, .hook = &times});
  const ProcessorTime watch;
  const View view = analyzer.view(scene.camera);
  std::vector<double> numbers = times.seconds();
  numbers.push_back(watch.seconds());
  numbers.push_back(static_cast<double>(peak_bytes() - before) / static_cast<double>(scene.mesh->facet_count()));
  return numbers;
}

// Project, sweep, rebuild, reflect, label.
std::vector<double> run_reflection(const std::shared_ptr<const CutMesh>& mesh, const std::vector<Panel>& panels) {
  StageTimes times;
  const Analyzer analyzer(mesh, {.sides = SidesPolicy::both, .hook = &times});
  const MirrorWorld world = analyzer.world(panels);
  const View view = analyzer.view(view_from_above(), world);
  const std::vector<double>& seconds = times.seconds();
  return {seconds[3], seconds[0] + seconds[1] + seconds[2] + seconds[4]};
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
  const auto mesh = std::make_shared<const CutMesh>(uncrossed(terrain(triangles)));
  const std::vector<Panel> lamp{{"lamp", {{-1, 9, -1}, {1, 9, -1}, {1, 9, 1}, {-1, 9, 1}}, {}}};
  const Outcome outcome = run_in_turns({[&] { return run_reflection(mesh, lamp); }}, limits).front();
  return {figure_of(outcome, 0, limits), figure_of(outcome, 1, limits)};
}

}  // namespace sightline::bench
