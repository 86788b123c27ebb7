#include "cli/command_options.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "cli/options/option_values.h"
#include "cli/scene/extreme_families.h"
#include "cli/scene/scene_file.h"
#include "cli/system/memory_limit.h"
#include "cli/trace/trace_examples.h"
#include "peers/peer_list.h"

namespace sightline::cli {

namespace {

constexpr int most_threads = 1024;
constexpr int most_pixels = 16384;  // along each side
constexpr double default_time_limit = 60;

std::optional<std::string> given(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional<std::string>(text);
}

std::optional<SidesPolicy> parsed_sides(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto sides = sides_policy(text);
  if (!sides) throw CommandLineError(fmt::format("--sides: '{}' is not auto, front or both; choose one of them", text));
  return sides;
}

std::vector<std::string> parsed_peers(const std::string& text) {
  std::vector<std::string> known;
  for (const peers::Peer& peer : peers::all_peers()) known.push_back(peer.name);
  if (text.empty()) return known;
  std::vector<std::string> wanted;
  for (const std::string_view name : split(text, ',')) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw CommandLineError(
          fmt::format("--peers: there is no '{}'; there are {}; choose from them", name, fmt::join(known, ", ")));
    wanted.emplace_back(name);
  }
  return wanted;
}

std::vector<int> parsed_resolutions(const std::string& text) {
  const std::string list = text.empty() ? "64,256,1024" : text;
  std::vector<int> resolutions;
  for (const std::string_view part : split(list, ',')) {
    resolutions.push_back(parsed_whole_number(part, "--resolution", 1, most_pixels));
  }
  std::sort(resolutions.begin(), resolutions.end());
  resolutions.erase(std::unique(resolutions.begin(), resolutions.end()), resolutions.end());
  return resolutions;
}

double parsed_time_limit(const std::string& text) {
  if (text.empty()) return default_time_limit;
  const double seconds = parsed_number(text, "--time-limit");
  if (seconds <= 0)
    throw CommandLineError(fmt::format("--time-limit: '{}' is not more than 0; give more seconds", text));
  return seconds;
}

std::uint64_t memory_limit(const std::string& text) {
  if (text.empty()) return default_memory_limit();
  const auto bytes = parse_bytes(text);
  if (!bytes)
    throw CommandLineError(
        fmt::format("--max-memory: '{}' is not a number of bytes; write one, like 800M or 4G", text));
  if (*bytes < smallest_memory_limit)
    throw CommandLineError(
        fmt::format("--max-memory: {} is less than {}; give at least that", text, bytes_text(smallest_memory_limit)));
  return *bytes;
}

void declare_computation(CLI::App& analyze, AnalyzeTexts& texts) {
  analyze.add_option("--sides", texts.sides, "which sides of faces count (auto)")->type_name("auto|front|both");
  analyze.add_option("--arithmetic", texts.arithmetic, "in which every decision is taken (unrounded)")
      ->type_name("float|double|exact|unrounded");
  analyze.add_option("--grid-bits", texts.grid_bits, "round to a grid of 2^N cells in the half window")->type_name("N");
  analyze.add_option("--engine", texts.engine, "sweep by need, or everything: same result (fast)")
      ->type_name("fast|full");
  analyze.add_option("--threads", texts.threads, "how many work at once: same result (all)")->type_name("N");
}

void declare_results(CLI::App& analyze, AnalyzeTexts& texts) {
  analyze.add_option("-o,--output", texts.output, "folder for results, with one per camera")->type_name("DIR");
  analyze.add_option("--max-memory", texts.max_memory, "stop where more is needed (3/4 of it all)")
      ->type_name("BYTES[K|M|G|T]");
  analyze.add_flag("--report", texts.report_page, "write report.html, too: the results in 3D");
  analyze.add_flag("--json", texts.json, "print the report on standard output");
  analyze.add_flag("--quiet", texts.quiet, "neither progress nor summary");
}

void require_place_for_results(const AnalyzeTexts& texts) {
  if (!texts.output.empty()) return;
  if (!texts.json)
    throw CommandLineError("the results have no place; give -o DIR for them, or --json for the report alone");
  if (texts.report_page) throw CommandLineError("--report needs -o DIR, where report.html goes; give it, too");
}

Engine engine_of(const AnalyzeTexts& texts) {
  if (texts.engine.empty() || texts.engine == "fast") return Engine::fast;
  if (texts.engine == "full") return Engine::full;
  throw CommandLineError(fmt::format("--engine: '{}' is not fast or full; choose one of them", texts.engine));
}

std::size_t threads_of(const AnalyzeTexts& texts) {
  if (texts.threads.empty()) return static_cast<std::size_t>(tbb::info::default_concurrency());
  return static_cast<std::size_t>(parsed_whole_number(texts.threads, "--threads", 1, most_threads));
}

void require_family(const std::string& name) {
  const auto& all = extreme_families();
  const auto has_name = [&](const ExtremeFamily& family) { return family.name == name; };
  if (name.empty() || std::any_of(all.begin(), all.end(), has_name)) return;
  std::string names;
  for (const ExtremeFamily& family : all) names += (names.empty() ? "" : ", ") + family.name;
  throw CommandLineError(fmt::format("--family: there is no '{}'; there are {}; choose one", name, names));
}

void require_example(const std::string& name) {
  if (name.empty() || trace_example_named(name) != nullptr) return;
  throw CommandLineError(
      fmt::format("--example: there is no '{}'; choose one that sightline trace --list names", name));
}

void require_consistent(const TraceTexts& texts) {
  if (texts.list) return;
  if (texts.input.empty() == texts.example.empty())
    throw CommandLineError(
        "trace: one scene is needed; give a scene file, or --example NAME (--list names them), and not both");
  if (!texts.input.empty() && !is_scene_file(texts.input))
    throw CommandLineError(
        fmt::format("trace: '{}' is not a scene file (.toml); write one around a mesh", texts.input));
  if (texts.output.empty() && texts.log.empty())
    throw CommandLineError(
        "trace: nothing is to be written; give -o FILE for the page, --log FILE for the log, or both");
  if (!texts.example.empty() && !(texts.camera.empty() && texts.sides.empty()))
    throw CommandLineError(
        "trace: --camera and --sides go with a scene file, and an example has its own; leave them out");
}

}  // namespace

void declare_analyze(CLI::App& analyze, AnalyzeTexts& texts) {
  analyze.add_option("input", texts.input, "scene file, or mesh with --eye, --target, --fov-y")
      ->required()
      ->type_name("SCENE.toml|MESH");
  declare_camera(analyze, texts.camera);
  declare_computation(analyze, texts);
  declare_results(analyze, texts);
  analyze.footer(
      "Example: sightline analyze fixtures/demo/scene.toml -o out --report\n"
      "Example: sightline analyze a.obj --eye 0,1,3 --target 0,0,0 --fov-y 30 -o out");
}

AnalyzeOptions options_of(const AnalyzeTexts& texts) {
  require_place_for_results(texts);
  AnalyzeOptions options;
  options.input = texts.input;
  options.output = given(texts.output);
  options.sides = parsed_sides(texts.sides);
  options.max_memory = memory_limit(texts.max_memory);
  options.precision = parsed_precision(texts.arithmetic, texts.grid_bits);
  options.engine = engine_of(texts);
  options.threads = threads_of(texts);
  options.report_page = texts.report_page;
  options.json = texts.json;
  options.quiet = texts.quiet;
  options.camera = camera_of(texts.input, texts.camera);
  return options;
}

void declare_compare(CLI::App& compare, CompareTexts& texts) {
  compare.add_option("input", texts.input, "scene file, or mesh with --eye, --target, --fov-y")
      ->required()
      ->type_name("SCENE.toml|MESH");
  compare.add_option("--camera", texts.camera, "which of the scene's cameras (the first)")->type_name("NAME");
  declare_camera(compare, texts.mesh_camera);
  compare.add_option("--peers", texts.peers, "only these (all); a wrong name prints the list")->type_name("A,B,...");
  compare.add_option("--resolution", texts.resolution, "pixels a side of item buffers (64,256,1024)")
      ->type_name("N,N,...");
  compare.add_option("--time-limit", texts.time_limit, "processor time that each of them may take (60)")
      ->type_name("S");
  compare.add_option("-o,--output", texts.output, "folder for compare.html, .csv, .json, pictures")
      ->required()
      ->type_name("DIR");
  compare.add_flag("--quiet", texts.quiet, "neither progress nor summary");
  compare.footer("Example: sightline compare fixtures/demo/scene.toml --resolution 256 -o compared");
}

CompareOptions options_of(const CompareTexts& texts) {
  CompareOptions options;
  options.input = texts.input;
  options.output = texts.output;
  options.mesh_camera = camera_of(texts.input, texts.mesh_camera);
  options.camera = given(texts.camera);
  if (options.camera && options.mesh_camera)
    throw CommandLineError("--camera goes with a scene file; leave it out, or give one");
  options.peers = parsed_peers(texts.peers);
  options.resolutions = parsed_resolutions(texts.resolution);
  options.limit_seconds = parsed_time_limit(texts.time_limit);
  options.quiet = texts.quiet;
  return options;
}

void declare_stability(CLI::App& stability, StabilityTexts& texts) {
  stability.add_option("-o,--output", texts.output, "folder for stability.html, .csv, and plots")
      ->required()
      ->type_name("DIR");
  stability.add_option("--family", texts.family, "only this family of scenes (all)")->type_name("NAME");
  stability.add_flag("--quiet", texts.quiet, "neither progress nor summary");
  stability.footer("Example: sightline stability -o stability && xdg-open stability/stability.html");
}

StabilityOptions options_of(const StabilityTexts& texts) {
  require_family(texts.family);
  return {texts.output, given(texts.family), texts.quiet};
}

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
  trace.add_option("--grid-bits", texts.grid_bits, "the grid has 2^N cells in the half window (40)")->type_name("N");
  trace.footer("Example: sightline trace --example fang -o trace.html && xdg-open trace.html");
}

Precision traced_precision(const TraceTexts& texts) {
  const Precision precision = parsed_precision(texts.arithmetic, texts.grid_bits);
  if (precision.arithmetic == Arithmetic::unrounded)
    throw CommandLineError("--arithmetic: a trace shows the sweep on the grid; choose float, double or exact");
  return precision;
}

TraceOptions options_of(const TraceTexts& texts) {
  require_consistent(texts);
  require_example(texts.example);
  TraceOptions options;
  options.list = texts.list;
  options.input = given(texts.input);
  options.example = given(texts.example);
  options.output = given(texts.output);
  options.log = given(texts.log);
  options.camera = given(texts.camera);
  options.sides = parsed_sides(texts.sides);
  if (!texts.arithmetic.empty() || !texts.grid_bits.empty()) options.precision = traced_precision(texts);
  return options;
}

}  // namespace sightline::cli
