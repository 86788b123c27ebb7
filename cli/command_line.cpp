#include "cli/command_line.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "cli/completion.h"
#include "cli/memory_limit.h"
#include "cli/scene_file.h"
#include "cli/stability_families.h"

namespace sightline {

namespace {

constexpr int most_threads = 1024;

// The options as texts: numbers are parsed here and not by CLI11, which goes through the locale.
struct AnalyzeTexts {
  std::string input, output, sides, eye, target, up, fov_y, aspect, arithmetic, grid_bits, engine, threads, max_memory;
  bool report_page = false;
  bool json = false;
  bool quiet = false;
};

struct StabilityTexts {
  std::string output, family;
  bool quiet = false;
};

double parsed_number(std::string_view text, std::string_view option) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw CommandLineError(fmt::format("{}: '{}' is not a number", option, text));
  }
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

Vector3 parsed_vector(std::string_view text, std::string_view option) {
  const auto parts = split(text, ',');
  if (parts.size() != 3) throw CommandLineError(fmt::format("{}: '{}' is not of the form X,Y,Z", option, text));
  return {parsed_number(parts[0], option), parsed_number(parts[1], option), parsed_number(parts[2], option)};
}

Camera camera_of(const AnalyzeTexts& texts) {
  if (texts.eye.empty() || texts.target.empty() || texts.fov_y.empty()) {
    throw CommandLineError("a mesh needs a camera: give --eye, --target and --fov-y, or a scene file (.toml)");
  }
  ViewPoint view;
  view.eye = parsed_vector(texts.eye, "--eye");
  view.target = parsed_vector(texts.target, "--target");
  if (!texts.up.empty()) view.up = parsed_vector(texts.up, "--up");
  if (!texts.aspect.empty()) view.aspect = parsed_number(texts.aspect, "--aspect");
  try {
    return perspective_camera("view", view, parsed_number(texts.fov_y, "--fov-y"));
  } catch (const CameraError& error) {
    throw CommandLineError(error.what());
  }
}

void refuse_camera(const AnalyzeTexts& texts) {
  for (const std::string* text : {&texts.eye, &texts.target, &texts.up, &texts.fov_y, &texts.aspect}) {
    if (!text->empty()) {
      throw CommandLineError(
          "--eye, --target, --up, --fov-y and --aspect go with a mesh; a scene file has its own cameras");
    }
  }
}

std::uint64_t memory_limit(const std::string& text) {
  if (text.empty()) return default_memory_limit();
  const auto bytes = parse_bytes(text);
  if (!bytes) throw CommandLineError(fmt::format("--max-memory: '{}' is not a number of bytes, like 800M or 4G", text));
  if (*bytes < smallest_memory_limit)
    throw CommandLineError(fmt::format("--max-memory: {} is less than {}", text, bytes_text(smallest_memory_limit)));
  return *bytes;
}

Engine engine_of(const AnalyzeTexts& texts) {
  if (texts.engine.empty() || texts.engine == "fast") return Engine::fast;
  if (texts.engine == "full") return Engine::full;
  throw CommandLineError(fmt::format("--engine: '{}' is not fast or full", texts.engine));
}

std::size_t threads_of(const AnalyzeTexts& texts) {
  if (texts.threads.empty()) return static_cast<std::size_t>(tbb::info::default_concurrency());
  const double threads = parsed_number(texts.threads, "--threads");
  if (threads != std::floor(threads) || threads < 1 || threads > most_threads)
    throw CommandLineError(
        fmt::format("--threads: '{}' is not a whole number from 1 to {}", texts.threads, most_threads));
  return static_cast<std::size_t>(threads);
}

AnalyzeOptions options_of(const AnalyzeTexts& texts) {
  AnalyzeOptions options;
  options.input = texts.input;
  if (!texts.output.empty()) options.output = texts.output;
  if (!options.output && !texts.json)
    throw CommandLineError("give -o DIR for the results, or --json for the report alone");
  if (!options.output && texts.report_page) throw CommandLineError("--report needs -o DIR: report.html goes there");
  if (!texts.sides.empty()) {
    options.sides = sides_policy(texts.sides);
    if (!options.sides) throw CommandLineError(fmt::format("--sides: '{}' is not auto, front or both", texts.sides));
  }
  options.max_memory = memory_limit(texts.max_memory);
  options.precision = parsed_precision(texts.arithmetic, texts.grid_bits);
  options.engine = engine_of(texts);
  options.threads = threads_of(texts);
  options.report_page = texts.report_page;
  options.json = texts.json;
  options.quiet = texts.quiet;
  if (options.input_is_scene()) {
    refuse_camera(texts);
  } else {
    options.camera = camera_of(texts);
  }
  return options;
}

StabilityOptions options_of(const StabilityTexts& texts) {
  const auto& all = stability_families();
  const auto has_name = [&](const StabilityFamily& family) { return family.name == texts.family; };
  StabilityOptions options{texts.output, std::nullopt, texts.quiet};
  if (texts.family.empty()) return options;
  if (std::none_of(all.begin(), all.end(), has_name)) {
    std::string names;
    for (const StabilityFamily& family : all) names += (names.empty() ? "" : ", ") + family.name;
    throw CommandLineError(fmt::format("--family: there is no '{}'; there are {}", texts.family, names));
  }
  options.family = texts.family;
  return options;
}

void declare_stability(CLI::App& stability, StabilityTexts& texts) {
  stability.add_option("-o,--output", texts.output, "folder for stability.csv, a plot per family, and stability.html")
      ->required()
      ->type_name("DIR");
  stability.add_option("--family", texts.family, "only this family of scenes (all)")->type_name("NAME");
  stability.add_flag("--quiet", texts.quiet, "neither progress nor summary");
  stability.footer("Example: sightline stability -o stability && xdg-open stability/stability.html");
}

void declare_analyze(CLI::App& analyze, AnalyzeTexts& texts) {
  analyze.add_option("input", texts.input, "a scene file (.toml), or a mesh (.obj) with a camera from the options")
      ->required()
      ->type_name("SCENE.toml|MESH.obj");
  analyze.add_option("--eye", texts.eye, "where the camera is")->type_name("X,Y,Z");
  analyze.add_option("--target", texts.target, "what it looks at")->type_name("X,Y,Z");
  analyze.add_option("--up", texts.up, "what is up (0,1,0)")->type_name("X,Y,Z");
  analyze.add_option("--fov-y", texts.fov_y, "vertical field of view in degrees")->type_name("DEG");
  analyze.add_option("--aspect", texts.aspect, "the window's width over its height (1)")->type_name("R");
  analyze.add_option("--sides", texts.sides, "which sides of faces count (auto)")->type_name("auto|front|both");
  analyze.add_option("--arithmetic", texts.arithmetic, "in which every decision is taken (exact)")
      ->type_name("float|double|exact");
  analyze.add_option("--grid-bits", texts.grid_bits, "the image's grid has 2^N cells in the half window (40)")
      ->type_name("N");
  analyze.add_option("--engine", texts.engine, "sweep what the scene requires, or everything: same result (fast)")
      ->type_name("fast|full");
  analyze.add_option("--threads", texts.threads, "how many work at once: same result (all that there are)")
      ->type_name("N");
  analyze.add_option("-o,--output", texts.output, "folder for the results, one folder in it per camera")
      ->type_name("DIR");
  analyze.add_option("--max-memory", texts.max_memory, "stop where more is needed (3/4 of the machine's memory)")
      ->type_name("BYTES[K|M|G|T]");
  analyze.add_flag("--report", texts.report_page, "write report.html, too: the results in 3D, in one page");
  analyze.add_flag("--json", texts.json, "print the report on standard output");
  analyze.add_flag("--quiet", texts.quiet, "neither progress nor summary");
  analyze.footer(
      "Example: sightline analyze fixtures/demo/scene.toml -o out --report\n"
      "Example: sightline analyze bunny.obj --eye 0,1,3 --target 0,0.1,0 --fov-y 30 -o out");
}

void declare_completion(CLI::App& completion, std::string& shell) {
  completion.add_option("shell", shell, "for which shell")->required()->type_name("bash|zsh|fish");
  completion.footer("Example: source <(sightline completion bash)");
}

std::string completion_for(const CLI::App& app, const std::string& name) {
  const auto shell = shell_named(name);
  if (!shell) throw CommandLineError(fmt::format("completion: '{}' is not bash, zsh or fish", name));
  return completion_script(app, *shell);
}

// Those of all commands, below the help that is about none of them.
std::string examples(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    text += (text.empty() ? "" : "\n") + command->get_footer();
  return text;
}

}  // namespace

bool AnalyzeOptions::input_is_scene() const { return input.ends_with(".toml") || input.ends_with(".TOML"); }

Precision parsed_precision(const std::string& arithmetic_text, const std::string& grid_bits) {
  Precision precision;
  if (!arithmetic_text.empty()) {
    const auto arithmetic = arithmetic_named(arithmetic_text);
    if (!arithmetic) {
      throw CommandLineError(fmt::format("--arithmetic: '{}' is not float, double or exact", arithmetic_text));
    }
    precision.arithmetic = *arithmetic;
  }
  if (!grid_bits.empty()) {
    const double bits = parsed_number(grid_bits, "--grid-bits");
    if (bits != std::floor(bits) || bits < smallest_grid_bits || bits > default_grid_bits) {
      throw CommandLineError(fmt::format("--grid-bits: '{}' is not a whole number from {} to {}", grid_bits,
                                         smallest_grid_bits, default_grid_bits));
    }
    precision.grid_bits = static_cast<int>(bits);
  }
  return precision;
}

Request parse_command_line(int argc, const char* const* argv) {
  CLI::App app("sightline: exactly which part of every triangle of a surface a camera sees", "sightline");
  app.set_version_flag("--version", "sightline " SIGHTLINE_VERSION);
  app.require_subcommand(1);
  CLI::App* analyze = app.add_subcommand("analyze", "Label a mesh with what each camera sees of it");
  AnalyzeTexts texts;
  declare_analyze(*analyze, texts);
  CLI::App* stability = app.add_subcommand(
      "stability", "Measure where float, double and exact arithmetic break, on scenes that go to extremes");
  StabilityTexts stability_texts;
  declare_stability(*stability, stability_texts);
  CLI::App* trace =
      app.add_subcommand("trace", "Step through the sweep of one camera, on a page that needs no network");
  TraceTexts trace_texts;
  declare_trace(*trace, trace_texts);
  CLI::App* completion = app.add_subcommand("completion", "Print the completion script of a shell");
  std::string shell;
  declare_completion(*completion, shell);
  app.footer(examples(app));
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return RequestedText{app.help()};
  } catch (const CLI::CallForVersion& version) {
    return RequestedText{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw CommandLineError(error.what());
  }
  if (completion->parsed()) return RequestedText{completion_for(app, shell)};
  if (stability->parsed()) return options_of(stability_texts);
  if (trace->parsed()) return options_of(trace_texts);
  return options_of(texts);
}

}  // namespace sightline
