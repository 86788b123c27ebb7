// The command `sightline analyze`: from options to files.
//
// Errors: InputError, CameraError, OutputError; InternalError.
#pragma once

#include <string>

#include "cli/options/requests.h"

namespace sightline::cli {

// Returns what belongs on standard output: the summary, or with --json the report (an array for several cameras).
[[nodiscard]] std::string analyze_command(const AnalyzeOptions& options);

}  // namespace sightline::cli
