// The command line of `sightline compare`.
//
// Errors: CommandLineError.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/camera_options.h"
#include "cli/options/requests.h"

namespace sightline::cli {

// The options as texts.
struct CompareTexts {
  std::string input, output, camera, peers, resolution, time_limit;
  CameraTexts mesh_camera;
  bool quiet = false;
};

void declare_compare(CLI::App& compare, CompareTexts& texts);
[[nodiscard]] CompareOptions options_of(const CompareTexts& texts);

}  // namespace sightline::cli
