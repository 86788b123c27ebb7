// The command line of `sightline trace`.
//
// In:  its arguments as texts. Out: what to do.
// Errors: CommandLineError.
#pragma once

#include <string>

#include "cli/options/requests.h"

namespace CLI {
class App;
}

namespace sightline::cli {

struct TraceTexts {
  std::string input, example, output, log, camera, sides, arithmetic, grid_bits;
  bool list = false;
};

void declare_trace(CLI::App& trace, TraceTexts& texts);

[[nodiscard]] TraceOptions options_of(const TraceTexts& texts);

}  // namespace sightline::cli
