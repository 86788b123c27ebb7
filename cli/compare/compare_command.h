// The command `sightline compare`: one camera of a scene, seen by every peer.
//
// Errors: InputError, CameraError, OutputError; InternalError; std::system_error where no process can be started.
#pragma once

#include <string>

#include "cli/options/requests.h"

namespace sightline::cli {

// Returns what belongs on standard output: a line per run.
[[nodiscard]] std::string compare_command(const CompareOptions& options);

}  // namespace sightline::cli
