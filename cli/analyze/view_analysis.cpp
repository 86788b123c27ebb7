#include "cli/analyze/view_analysis.h"

#include "cli/analyze/memory_estimate.h"

namespace sightline::cli {

namespace {

const char* words_of(Stage stage) {
  switch (stage) {
    case Stage::contacts:
    case Stage::cut:
      return "look for faces that pass through each other";
    case Stage::sides:
    case Stage::project:
      return ": project";
    case Stage::sweep:
      return ": sweep";
    case Stage::reconstruct:
      return ": reconstruct the visible polygons";
    case Stage::reflect:
      return ": reflect the panels";
    case Stage::label:
      return ": label the surface";
  }
  return "";
}

double& seconds_of(StageSeconds& seconds, Stage stage) {
  switch (stage) {
    case Stage::contacts:
      return seconds.contacts;
    case Stage::cut:
      return seconds.cut;
    case Stage::sides:
      return seconds.sides;
    case Stage::project:
      return seconds.project;
    case Stage::sweep:
      return seconds.sweep;
    case Stage::reconstruct:
      return seconds.reconstruct;
    case Stage::reflect:
      return seconds.reflect;
    case Stage::label:
      break;
  }
  return seconds.label;
}

}  // namespace

void AnalysisWatch::begins(Stage stage) { progress_.stage(camera_ + words_of(stage)); }

void AnalysisWatch::ended(Stage stage, double seconds) { seconds_of(seconds_, stage) = seconds; }

void AnalysisWatch::projected(const ProjectedScene& scene) {
  require_memory_for_view(scene, max_memory_);
  sweep_.reset();
  if (progress_.shown()) sweep_.emplace(progress_, scene.points.size());
}

SweepObserver* AnalysisWatch::sweep_observer() { return sweep_ ? &*sweep_ : nullptr; }

}  // namespace sightline::cli
