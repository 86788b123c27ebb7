// Work in a process of its own, with a limit on its time (separate_process.h), as often as one likes.
//
// In:  work that gives numbers, and a limit of processor time in seconds.
// Out: the numbers, or why there are none. Repeated, the median of each of the numbers.
// Errors: as a separate process.
#pragma once

#include <functional>
#include <vector>

#include "cli/system/separate_process.h"

namespace sightline::bench {

using Work = std::function<std::vector<double>()>;

struct Outcome {
  using End = cli::SeparateOutcome::End;
  End end = End::failed;
  std::vector<double> numbers;
};

struct RunLimits {
  double seconds = 60;  // of one run
  int runs = 3;         // fewer where they take more than the limit together
};

[[nodiscard]] Outcome run_once(const Work& work, double limit_seconds);

// Each work runs once, then each a second time, and so on: what slows the machine for a while slows them all, and
// leaves their ratios. One that does not end is not run again.
[[nodiscard]] std::vector<Outcome> run_in_turns(const std::vector<Work>& works, const RunLimits& limits);

}  // namespace sightline::bench
