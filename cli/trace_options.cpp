#include "cli/trace_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/options/option_values.h"
#include "cli/options/requests.h"
#include "cli/scene/scene_file.h"
#include "cli/trace/trace_examples.h"

namespace sightline::cli {

namespace {

std::optional<std::string> given(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional<std::string>(text);
}

void require_consistent(const TraceTexts& texts) {
  if (texts.list) return;
  if (texts.input.empty() == texts.example.empty())
    throw CommandLineError("trace: give a scene file, or --example NAME (--list names them), and not both");
  if (!texts.input.empty() && !texts.input.ends_with(".toml") && !texts.input.ends_with(".TOML"))
    throw CommandLineError(
        fmt::format("trace: '{}' is not a scene file (.toml); a mesh needs one around it", texts.input));
  if (texts.output.empty() && texts.log.empty())
    throw CommandLineError("trace: give -o FILE for the page, --log FILE for the log, or both");
  if (!texts.example.empty() && !(texts.camera.empty() && texts.sides.empty()))
    throw CommandLineError("trace: --camera and --sides go with a scene file; an example has its own");
}

}  // namespace

void declare_trace(CLI::App& trace, TraceTexts& texts) {
  trace.add_option("input", texts.input, "a scene file (.toml)")->type_name("SCENE.toml");
  trace.add_option("--example", texts.example, "a built-in scene instead")->type_name("NAME");
  trace.add_flag("--list", texts.list, "print the names of the built-in scenes");
  trace.add_option("-o,--output", texts.output, "the page: one file that needs no network")->type_name("FILE.html");
  trace.add_option("--log", texts.log, "the log behind the page, as JSON")->type_name("FILE.json");
  trace.add_option("--camera", texts.camera, "which of the scene's cameras")->type_name("NAME");
  trace.add_option("--sides", texts.sides, "which sides of faces count (as the scene has it)")
      ->type_name("auto|front|both");
  trace.add_option("--arithmetic", texts.arithmetic, "float and double are shown beside exact (exact)")
      ->type_name("float|double|exact");
  trace.add_option("--grid-bits", texts.grid_bits, "the image's grid has 2^N cells in the half window (40)")
      ->type_name("N");
  trace.footer("Example: sightline trace --example fang -o trace.html && xdg-open trace.html");
}

TraceOptions options_of(const TraceTexts& texts) {
  require_consistent(texts);
  TraceOptions options;
  options.list = texts.list;
  options.input = given(texts.input);
  options.example = given(texts.example);
  options.output = given(texts.output);
  options.log = given(texts.log);
  options.camera = given(texts.camera);
  if (options.example && trace_example_named(*options.example) == nullptr)
    throw CommandLineError(
        fmt::format("--example: there is no '{}'; sightline trace --list names them", texts.example));
  if (!texts.sides.empty()) {
    options.sides = sides_policy(texts.sides);
    if (!options.sides) throw CommandLineError(fmt::format("--sides: '{}' is not auto, front or both", texts.sides));
  }
  if (!texts.arithmetic.empty() || !texts.grid_bits.empty())
    options.precision = parsed_precision(texts.arithmetic, texts.grid_bits);
  return options;
}

}  // namespace sightline::cli
