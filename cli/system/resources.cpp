#include "cli/system/resources.h"

#include <malloc.h>
#include <sys/resource.h>

#include <fstream>
#include <string>
#include <string_view>

namespace sightline::cli {

namespace {

std::size_t status_bytes(std::string_view key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kibibytes = 0;
    if (word == key && status >> kibibytes) return 1024 * kibibytes;
  }
  return 0;
}

}  // namespace

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in kibibytes
}

std::size_t resident_bytes() { return status_bytes("VmRSS:"); }

std::size_t peak_bytes() { return status_bytes("VmHWM:"); }

void reset_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

}  // namespace sightline::cli
