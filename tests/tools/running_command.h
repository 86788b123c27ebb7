// The built command is a process of its own, to be sent signals, held to limits, and measured.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/tools/command_runner.h"

namespace sightline::tests {

struct ProcessLimits {
  rlim_t file_size = RLIM_INFINITY;
  bool ignores_interrupts = false;  // SIGINT, as nohup does with SIGHUP
};

struct Outcome {
  int exit_code = 0;  // 1000 + the signal's number where a signal ended it
  std::string out;
  std::string err;
  double seconds = 0;
  double cpu_seconds = 0;               // that it had a processor: no matter what else the machine does
  std::uint64_t peak_memory_bytes = 0;  // at least that of the test's own process, from which it was started
};

class RunningCommand {
 public:
  // Starts SIGHTLINE_COMMAND with the arguments.
  explicit RunningCommand(const std::vector<std::string>& arguments, const ProcessLimits& limits = {});
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;
  // Kills it if nobody has waited for it.
  ~RunningCommand();

  void send(int signal) const;
  Outcome wait();

 private:
  TemporaryFolder folder_;
  std::chrono::steady_clock::time_point start_;
  pid_t process_ = 0;
};

[[nodiscard]] inline Outcome run_to_end(const std::vector<std::string>& arguments, const ProcessLimits& limits = {}) {
  return RunningCommand(arguments, limits).wait();
}

}  // namespace sightline::tests
