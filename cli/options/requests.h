// The command line asks for one of these: there is a request per command.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/scene/scene_file.h"
#include "geometry/numbers/arithmetic.h"
#include "geometry/numbers/errors.h"
#include "sweep/engine.h"

namespace sightline::cli {

// The command line is wrong; one line.
class CommandLineError : public Error {
  using Error::Error;
};

struct AnalyzeOptions {
  std::string input;                  // a scene file where it ends in .toml, else a mesh
  std::optional<std::string> output;  // the folder for the results; none: no files, which needs json
  std::optional<SidesPolicy> sides;   // instead of the scene file's
  std::optional<Camera> camera;       // set where the input is a mesh
  std::uint64_t max_memory = 0;       // in bytes
  Precision precision;
  Engine engine = Engine::fast;
  std::size_t threads = 1;
  bool report_page = false;  // needs output
  bool json = false;
  bool quiet = false;
};

struct StabilityOptions {
  std::string output;                 // the folder for the results
  std::optional<std::string> family;  // the only one to run; its name exists
  bool quiet = false;
};

struct CompareOptions {
  std::string input;                  // a scene file where it ends in .toml, else a mesh
  std::string output;                 // the folder for the results
  std::optional<std::string> camera;  // of the scene; none: the first
  std::optional<Camera> mesh_camera;  // set where the input is a mesh
  std::vector<std::string> peers;     // their names, which exist
  std::vector<int> resolutions;       // ascending, distinct
  double limit_seconds = 0;           // of processor time, for each run
  bool quiet = false;
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

// --help or --version asked for this text; print it and be done.
struct RequestedText {
  std::string text;
};

using Request = std::variant<AnalyzeOptions, CompareOptions, StabilityOptions, TraceOptions, RequestedText>;

}  // namespace sightline::cli
