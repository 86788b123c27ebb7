// The command line: sightline analyze SCENE.toml|MESH ..., sightline compare ..., sightline stability ..., sightline
// trace ...
//
// In:  the arguments. Out: what to do, or a text that was asked for (help, version).
// Errors: CommandLineError, one line.
#pragma once

#include "cli/options/requests.h"

namespace sightline::cli {

[[nodiscard]] Request parse_command_line(int argc, const char* const* argv);

}  // namespace sightline::cli
