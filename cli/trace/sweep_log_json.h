// A sweep's log as JSON: docs/trace.md says what each member means.
//
// Equal bytes for equal logs. Steps, and the steps at which segments open and close, are numbered from 1; points,
// edges and faces from 0, as in their lists.
#pragma once

#include <span>
#include <string>

#include "cli/results/json.h"
#include "trace/sweep_log.h"

namespace sightline::cli {

// This is what was traced; texts are as the user gave them.
struct TracedScene {
  std::string title;
  std::string what;
  std::string camera;
  double aspect = 1;
};

// The sweep that was asked for first, and where its arithmetic is not exact the exact one after it.
[[nodiscard]] Json sweep_logs_json(const TracedScene& scene, std::span<const trace::SweepLog> sweeps);

}  // namespace sightline::cli
