#include "bench/measuring/machine.h"

#include <fstream>

namespace sightline::bench {
namespace {

std::string compiler() {
#ifdef __clang__
  return __VERSION__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string processor() {
  std::ifstream information("/proc/cpuinfo");
  for (std::string line; std::getline(information, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "";
}

}  // namespace

std::string machine_line() {
  const std::string name = processor();
  return (name.empty() ? "" : name + ", ") + compiler();
}

}  // namespace sightline::bench
