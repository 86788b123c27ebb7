// What `sightline compare` found: the scene and a run per peer and resolution.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/compare/compare_run.h"

namespace sightline::cli {

struct Comparison {
  std::string scene;   // the file
  std::string camera;  // its name
  std::size_t faces = 0;
  std::size_t polygons = 0;  // in view: what the peers begin with
  std::size_t visible_faces = 0;
  double limit_seconds = 0;
  std::vector<CompareRun> runs;  // by peer, then by resolution
};

// The name of a run's picture, without what it shows and ".png": the peer and, where it has pixels, the resolution.
[[nodiscard]] std::string picture_name(const CompareRun& run);

// The runs of one peer each, in the order of the runs.
[[nodiscard]] std::vector<std::vector<const CompareRun*>> by_peer(const Comparison& comparison);

}  // namespace sightline::cli
