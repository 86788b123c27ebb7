// The options of each command: how they are declared, and what they ask for.
//
// In:  the options as texts, once the command line is parsed. Out: a request.
// Errors: CommandLineError, one line.
#pragma once

#include <string>

#include "cli/options/camera_options.h"
#include "cli/options/requests.h"

namespace sightline::cli {

struct AnalyzeTexts {
  std::string input, output, sides, arithmetic, grid_bits, engine, threads, max_memory;
  CameraTexts camera;
  bool report_page = false;
  bool json = false;
  bool quiet = false;
};

struct CompareTexts {
  std::string input, output, camera, peers, resolution, time_limit;
  CameraTexts mesh_camera;
  bool quiet = false;
};

struct StabilityTexts {
  std::string output, family;
  bool quiet = false;
};

struct TraceTexts {
  std::string input, example, output, log, camera, sides, arithmetic, grid_bits;
  bool list = false;
};

void declare_analyze(CLI::App& analyze, AnalyzeTexts& texts);
void declare_compare(CLI::App& compare, CompareTexts& texts);
void declare_stability(CLI::App& stability, StabilityTexts& texts);
void declare_trace(CLI::App& trace, TraceTexts& texts);

[[nodiscard]] AnalyzeOptions options_of(const AnalyzeTexts& texts);
[[nodiscard]] CompareOptions options_of(const CompareTexts& texts);
[[nodiscard]] StabilityOptions options_of(const StabilityTexts& texts);
[[nodiscard]] TraceOptions options_of(const TraceTexts& texts);

}  // namespace sightline::cli
