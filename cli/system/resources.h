// What a run costs: time and memory.
#pragma once

#include <chrono>
#include <cstdint>

namespace sightline::cli {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

// The most memory that the process has held at once.
[[nodiscard]] std::uint64_t peak_memory_bytes();

}  // namespace sightline::cli
