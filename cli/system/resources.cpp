#include "cli/system/resources.h"

#include <sys/resource.h>

namespace sightline::cli {

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in kibibytes
}

}  // namespace sightline::cli
