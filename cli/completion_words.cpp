#include "cli/completion_words.h"

#include <algorithm>

namespace sightline::cli {

namespace {

// As the help has them: "auto|front|both". Upper-case letters stand for something.
bool lists_words(const std::string& type_name) {
  const auto is_part = [](char c) { return (c >= 'a' && c <= 'z') || c == '|' || c == '-'; };
  return type_name.find('|') != std::string::npos && std::all_of(type_name.begin(), type_name.end(), is_part);
}

Follows what_follows(const CLI::Option& option, const std::string& type_name) {
  if (option.get_items_expected_max() == 0) return Follows::nothing;
  if (type_name == "DIR") return Follows::folder;
  return lists_words(type_name) ? Follows::words : Follows::other;
}

std::string first_of(const std::vector<std::string>& names) { return names.empty() ? "" : names.front(); }

CompletionOption completion_option(const CLI::Option& option) {
  CompletionOption result{first_of(option.get_lnames()),
                          first_of(option.get_snames()),
                          option.get_description(),
                          option.get_type_name(),
                          Follows::nothing,
                          ""};
  result.follows = what_follows(option, result.type_name);
  result.words = result.type_name;
  std::replace(result.words.begin(), result.words.end(), '|', ' ');
  return result;
}

CompletionCommand completion_command(const CLI::App& app, const std::string& name) {
  CompletionCommand command{name, app.get_description(), {}};
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) command.options.push_back(completion_option(*option));
  }
  return command;
}

}  // namespace

std::vector<CompletionCommand> completion_commands(const CLI::App& app) {
  std::vector<CompletionCommand> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(completion_command(*command, command->get_name()));
  commands.push_back(completion_command(app, ""));
  return commands;
}

std::string option_words(const CompletionCommand& command) {
  std::string words;
  for (const CompletionOption& option : command.options) {
    if (!option.long_name.empty()) words += (words.empty() ? "--" : " --") + option.long_name;
    if (!option.short_name.empty()) words += (words.empty() ? "-" : " -") + option.short_name;
  }
  return words;
}

}  // namespace sightline::cli
