// The command `sightline stability`: runs the families in every arithmetic and writes what came out.
//
// Errors: OutputError.
#pragma once

#include <string>

#include "cli/options/requests.h"

namespace sightline::cli {

// Returns what belongs on standard output: a sentence per family and arithmetic.
[[nodiscard]] std::string stability_command(const StabilityOptions& options);

}  // namespace sightline::cli
