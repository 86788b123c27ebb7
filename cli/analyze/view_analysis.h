// A mesh file and an analyzer of it, watched as the command does: progress, times, memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/analyze/surface_doubts.h"
#include "cli/system/progress.h"
#include "formats/reading/mesh_file.h"
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

// A mesh of a scene, and where its faces are among those of all meshes.
struct ScenePart {
  std::string file;
  std::string name;
  std::size_t first_face = 0;
  std::size_t face_count = 0;
};

// The input is read once for all cameras of a scene (scene_surface.h).
struct MeshInput : MeshFile {
  double read_seconds = 0;
  std::vector<ScenePart> parts;
  std::vector<std::uint8_t> of_interest;   // per face; empty: all are
  std::vector<std::uint8_t> mirror_faces;  // per face; empty: all mirror
  SurfaceDoubts doubts;
};

// A view and how it was computed.
struct ViewAnalysis {
  AnalysisOptions asked;
  View view;
  StageSeconds seconds;
};

}  // namespace sightline::cli
