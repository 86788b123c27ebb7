// The command `sightline trace`: the sweep of one camera, step by step, as a page and as a log.
//
// Where the arithmetic is not exact, the exact sweep is put beside it.
// Errors: CommandLineError for a camera that the scene has not, or where it has several and none is named; InputError,
//      also beyond most_traced_points, with what to do; CameraError, OutputError; PageError where the command was built
//      without pages.
#pragma once

#include <string>

#include "cli/options/requests.h"

namespace sightline::cli {

// Returns what belongs on standard output.
[[nodiscard]] std::string trace_command(const TraceOptions& options);

}  // namespace sightline::cli
