// The command line of sightline_side_by_side.
//
// In:  arguments. Out: what to measure. A wrong command line, and --help, end the program with a text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/measuring/limited_run.h"

namespace sightline::bench {

struct SideBySideOptions {
  std::vector<std::size_t> sizes{10000, 30000, 100000, 300000, 1000000};  // triangles, ascending
  std::size_t mirrors = 100000;                                           // triangles that may reflect a panel
  RunLimits limits;
  std::vector<std::string> only;  // names of families; empty: all
  bool rivals = true;
};

[[nodiscard]] SideBySideOptions parse_side_by_side_options(int argc, const char* const* argv);

}  // namespace sightline::bench
