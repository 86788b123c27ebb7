#include "cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/command_options.h"
#include "cli/completion.h"

namespace sightline::cli {

namespace {

// Every command has its texts here; parsing fills in those of the one that is asked for.
struct OptionTexts {
  AnalyzeTexts analyze;
  CompareTexts compare;
  StabilityTexts stability;
  TraceTexts trace;
  std::string shell;
};

void declare_completion(CLI::App& completion, std::string& shell) {
  completion.add_option("shell", shell, "for which shell")->required()->type_name("bash|zsh|fish");
  completion.footer("Example: source <(sightline completion bash)");
}

void declare_commands(CLI::App& app, OptionTexts& texts) {
  const auto command = [&app](const char* name, const char* does) -> CLI::App& {
    return *app.add_subcommand(name, does);
  };
  declare_analyze(command("analyze", "Label a mesh with what each camera sees of it"), texts.analyze);
  declare_compare(command("compare", "Measure the textbooks' algorithms on a scene"), texts.compare);
  declare_stability(command("stability", "Measure where float, double and exact break"), texts.stability);
  declare_trace(command("trace", "Step through the sweep of a camera, on a page"), texts.trace);
  declare_completion(command("completion", "Print the completion script of a shell"), texts.shell);
}

std::string completion_for(const CLI::App& app, const std::string& name) {
  const auto shell = shell_named(name);
  if (!shell)
    throw CommandLineError(fmt::format("completion: '{}' is not bash, zsh or fish; choose one of them", name));
  return completion_script(app, *shell);
}

// Those of all commands, below the help that is about none of them.
std::string examples(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    text += (text.empty() ? "" : "\n") + command->get_footer();
  return text;
}

Request request_of(const CLI::App& app, const OptionTexts& texts) {
  if (app.got_subcommand("compare")) return options_of(texts.compare);
  if (app.got_subcommand("completion")) return RequestedText{completion_for(app, texts.shell)};
  if (app.got_subcommand("stability")) return options_of(texts.stability);
  if (app.got_subcommand("trace")) return options_of(texts.trace);
  return options_of(texts.analyze);
}

}  // namespace

Request parse_command_line(int argc, const char* const* argv) {
  CLI::App app("sightline: exactly which part of every triangle of a surface a camera sees", "sightline");
  app.set_version_flag("--version", "sightline " SIGHTLINE_VERSION);
  app.require_subcommand(1);
  OptionTexts texts;
  declare_commands(app, texts);
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
  return request_of(app, texts);
}

}  // namespace sightline::cli
