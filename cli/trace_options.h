// The command line of `sightline trace`.
//
// In:  its arguments as texts. Out: what to do.
// Errors: CommandLineError.
#pragma once

#include <optional>
#include <string>

#include "cli/scene.h"
#include "geometry/arithmetic.h"

namespace CLI {
class App;
}

namespace sightline {

struct TraceTexts {
  std::string input, example, output, log, camera, sides, arithmetic, grid_bits;
  bool list = false;
};

struct TraceOptions {
  bool list = false;                   // of the built-in scenes; nothing else is done
  std::optional<std::string> input;    // a scene file
  std::optional<std::string> example;  // or the name of a built-in scene
  std::optional<std::string> output;   // the page; or
  std::optional<std::string> log;      // the log; at least one of them
  std::optional<std::string> camera;   // of the scene file; needed where it has several
  std::optional<SidesPolicy> sides;    // instead of the scene file's
  std::optional<Precision> precision;  // instead of exact, or the example's
};

void declare_trace(CLI::App& trace, TraceTexts& texts);

[[nodiscard]] TraceOptions options_of(const TraceTexts& texts);

}  // namespace sightline
