// A mesh file and an analyzer of it, watched as the command does: progress, times, memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/analyze/surface_doubts.h"
#include "cli/system/progress.h"
#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"
#include "sightline/analyzer.h"

namespace sightline::cli {

struct StageSeconds {
  double contacts = 0;
  double cut = 0;
  double sides = 0;
  double project = 0;
  double sweep = 0;
  double reconstruct = 0;
  double reflect = 0;
  double label = 0;
};

// Shows the stages of the analysis of a mesh and its views, takes their times, and ends a view for which there is not
// enough memory, with a MemoryError, before the sweep.
class AnalysisWatch : public AnalysisHook {
 public:
  AnalysisWatch(std::uint64_t max_memory, Progress& progress) : max_memory_(max_memory), progress_(progress) {}

  // The stages that follow are those of this camera's view.
  void look_at(const std::string& camera) { camera_ = camera; }

  void begins(Stage stage) override;
  void ended(Stage stage, double seconds) override;
  void projected(const ProjectedScene& scene) override;
  [[nodiscard]] SweepObserver* sweep_observer() override;

  // The times of the mesh's stages, and of the last view's.
  [[nodiscard]] const StageSeconds& seconds() const { return seconds_; }

 private:
  std::uint64_t max_memory_;
  Progress& progress_;
  std::string camera_;
  std::optional<SweepProgress> sweep_;
  StageSeconds seconds_;
};

// The input is read once for all cameras of a scene.
struct MeshInput : MeshFile {
  double read_seconds = 0;
  SurfaceDoubts doubts = {};
};

// Errors: InputError (see import_mesh).
[[nodiscard]] MeshInput read_mesh(const std::string& file, Normals normals, std::uint64_t max_memory,
                                  Progress& progress);

// A view and how it was computed.
struct ViewAnalysis {
  AnalysisOptions asked;
  View view;
  StageSeconds seconds;
};

}  // namespace sightline::cli
