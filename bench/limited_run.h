// Work that may take too long, or fail, in a process of its own.
//
// In:  the work, which gives numbers, and a limit of processor time in seconds.
// Out: the numbers, or why there are none. Repeated, the median of each of the numbers.
// Holds: the work starts with the memory of this process as it is and changes nothing in it; other processes on the
//      machine do not use up the limit.
// Complexity: of the work; a fork before it.
// Errors: std::system_error where no process can be started. An exception of the work is printed and ends as `failed`.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace sightline::bench {

using Work = std::function<std::vector<double>()>;

struct Outcome {
  enum class End : std::uint8_t { done, out_of_time, failed };
  End end = End::failed;
  std::vector<double> numbers;
};

struct RunLimits {
  double seconds = 60;  // of one run
  int runs = 3;         // fewer where they take more than the limit together
};

[[nodiscard]] Outcome run_once(const Work& work, double limit_seconds);

// One run of each, then another of each, and so on: what slows the machine for a while slows them all, and leaves their
// ratios. One that does not end is not run again.
[[nodiscard]] std::vector<Outcome> run_in_turns(const std::vector<Work>& works, const RunLimits& limits);

}  // namespace sightline::bench
