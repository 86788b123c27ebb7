// A run costs time and memory; both are measured here.
#pragma once

#include <sys/resource.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>

namespace sightline::cli {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

// This measures the processor time of this process, all its threads together: what else runs on the machine does not count.
class ProcessorTime {
 public:
  [[nodiscard]] double seconds() const { return now() - start_; }

 private:
  [[nodiscard]] static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double start_ = now();
};

// This measures the processes that it has started and that have ended.
class ChildrenTime {
 public:
  [[nodiscard]] double seconds() const { return now() - start_; }

 private:
  [[nodiscard]] static double now() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  }
  double start_ = now();
};

// The most memory that the process has held at once.
[[nodiscard]] std::uint64_t peak_memory_bytes();

// Returns what memory the process holds, as Linux counts it (/proc/self); 0 where it does not say. Asking takes about 0.1 ms.
[[nodiscard]] std::size_t resident_bytes();

// The most that was held since the last reset_peak().
[[nodiscard]] std::size_t peak_bytes();

// Gives back what is free first, so that it is not taken for something held.
void reset_peak();

}  // namespace sightline::cli
