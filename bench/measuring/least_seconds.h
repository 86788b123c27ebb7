// What a program of tables needs: the time of some work, and numbers as text.
//
// Processor time, the least of several runs.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <string>

#include "cli/system/resources.h"

namespace sightline::bench {

constexpr int runs = 3;

template <class Work>
double least_seconds(Work work) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs; ++run) {
    const cli::ProcessorTime watch;
    work();
    least = std::min(least, watch.seconds());
  }
  return least;
}

[[nodiscard]] inline std::string number(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

}  // namespace sightline::bench
