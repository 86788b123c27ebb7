// Work in a process of its own, with limits on its time and memory.
//
// In:  work that gives bytes, and a limit of processor time in seconds.
// Out: the bytes, or why there are none.
// Holds: the work starts with the memory of this process as it is and changes nothing in it; other processes on the
//      machine do not use up the limit; the process ends with this one, whatever ends this one. This process may have
//      one thread only when it starts another.
// Complexity: of the work; a fork before it.
// Errors: std::system_error where no process can be started. An exception of the work is printed and ends as `failed`.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace sightline::cli {

// To be called when the part of the work is done that the limit is for; the rest has no limit. If nobody calls it, the
// limit is for all.
using LimitedPartDone = std::function<void()>;
using SeparateWork = std::function<std::string(const LimitedPartDone&)>;

struct SeparateOutcome {
  enum class End : std::uint8_t { done, out_of_time, failed };
  End end = End::failed;
  std::string bytes;
};

[[nodiscard]] SeparateOutcome run_in_separate_process(const SeparateWork& work, double limit_seconds);

}  // namespace sightline::cli
