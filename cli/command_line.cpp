#include "cli/command_line.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/camera_options.h"
#include "cli/compare_options.h"
#include "cli/completion.h"
#include "cli/options/option_values.h"
#include "cli/scene/scene_file.h"
#include "cli/stability/stability_families.h"
#include "cli/system/memory_limit.h"
#include "cli/trace_options.h"

namespace sightline::cli {

namespace {

constexpr int most_threads = 1024;

// The options as texts.
struct AnalyzeTexts {
  std::string input, output, sides, arithmetic, grid_bits, engine, threads, max_memory;
  CameraTexts camera;
  bool report_page = false;
  bool json = false;
  bool quiet = false;
};

struct StabilityTexts {
  std::string output, family;
  bool quiet = false;
};

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
  return static_cast<std::size_t>(parsed_whole_number(texts.threads, "--threads", 1, most_threads));
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
  options.camera = camera_of(texts.input, texts.camera);
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
  declare_camera(analyze, texts.camera);
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

Request parse_command_line(int argc, const char* const* argv) {
  CLI::App app("sightline: exactly which part of every triangle of a surface a camera sees", "sightline");
  app.set_version_flag("--version", "sightline " SIGHTLINE_VERSION);
  app.require_subcommand(1);
  CLI::App* analyze = app.add_subcommand("analyze", "Label a mesh with what each camera sees of it");
  AnalyzeTexts texts;
  declare_analyze(*analyze, texts);
  CLI::App* compare =
      app.add_subcommand("compare", "Let the textbooks' algorithms see the same scene, and measure them");
  CompareTexts compare_texts;
  declare_compare(*compare, compare_texts);
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
  if (compare->parsed()) return options_of(compare_texts);
  if (completion->parsed()) return RequestedText{completion_for(app, shell)};
  if (stability->parsed()) return options_of(stability_texts);
  if (trace->parsed()) return options_of(trace_texts);
  return options_of(texts);
}

}  // namespace sightline::cli
