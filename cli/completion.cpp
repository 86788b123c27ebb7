#include "cli/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace sightline::cli {

namespace {

// This says what follows an option.
enum class Follows : std::uint8_t { nothing, words, folder, other };

struct CompletionOption {
  std::string long_name;   // without the hyphens; empty where there is none
  std::string short_name;  // likewise
  std::string description;
  std::string type_name;
  Follows follows = Follows::nothing;
  std::string words;  // with spaces between them
};

struct CompletionCommand {
  std::string name;
  std::string description;
  std::vector<CompletionOption> options;
};

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

// The last one has no name: the options without a command.
std::vector<CompletionCommand> completion_commands(const CLI::App& app) {
  std::vector<CompletionCommand> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    commands.push_back(completion_command(*command, command->get_name()));
  commands.push_back(completion_command(app, ""));
  return commands;
}

// "--name -n", for the options of a command.
std::string option_words(const CompletionCommand& command) {
  std::string words;
  for (const CompletionOption& option : command.options) {
    if (!option.long_name.empty()) words += (words.empty() ? "--" : " --") + option.long_name;
    if (!option.short_name.empty()) words += (words.empty() ? "-" : " -") + option.short_name;
  }
  return words;
}

// A description within single quotes; zsh reads [ ] and : within it.
std::string quoted_text(const std::string& text, bool for_zsh) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      if (for_zsh && (c == '[' || c == ']' || c == ':')) result += '\\';
      result += c;
    }
  }
  return result;
}

std::string command_names(const std::vector<CompletionCommand>& commands) {
  std::string names;
  for (const CompletionCommand& command : commands) names += command.name.empty() ? "" : command.name + ' ';
  return names;
}

constexpr const char* bash_head = R"(# Made by: sightline completion bash
_sightline() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options=
  COMPREPLY=()
)";
constexpr const char* bash_tail = R"(  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}
complete -o filenames -F _sightline sightline
)";

std::string bash_value(const CompletionCommand& command, const CompletionOption& option) {
  if (option.follows == Follows::nothing) return "";
  const std::string pattern =
      option.short_name.empty() ? fmt::format("{}:--{}", command.name, option.long_name)
                                : fmt::format("{0}:--{1}|{0}:-{2}", command.name, option.long_name, option.short_name);
  std::string reply;
  if (option.follows == Follows::folder) reply = "mapfile -t COMPREPLY < <(compgen -d -- \"$current\"); ";
  if (option.follows == Follows::words)
    reply = fmt::format("mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$current\"); ", option.words);
  return fmt::format("    {}) {}return ;;\n", pattern, reply);
}

std::string bash_script(const std::vector<CompletionCommand>& commands) {
  std::string text = bash_head;
  text += fmt::format(
      "  if [[ $COMP_CWORD -eq 1 ]]; then\n    mapfile -t COMPREPLY < <(compgen -W '{}{}' -- \"$current\")\n    "
      "return\n"
      "  fi\n  case ${{COMP_WORDS[1]}}:$previous in\n",
      command_names(commands), option_words(commands.back()));
  for (const CompletionCommand& command : commands) {
    for (const CompletionOption& option : command.options) text += bash_value(command, option);
  }
  text += "  esac\n  case ${COMP_WORDS[1]} in\n";
  for (const CompletionCommand& command : commands) {
    if (!command.name.empty()) text += fmt::format("    {}) options='{}' ;;\n", command.name, option_words(command));
  }
  return text + "  esac\n" + bash_tail;
}

std::string zsh_value(const CompletionOption& option) {
  if (option.follows == Follows::nothing) return "";
  if (option.follows == Follows::folder) return ":folder:_files -/";
  return option.follows == Follows::words ? ":value:(" + option.words + ")" : ":value:";
}

std::string zsh_options(const CompletionCommand& command) {
  std::string text;
  for (const CompletionOption& option : command.options) {
    const std::string rest = fmt::format("[{}]{}'", quoted_text(option.description, true), zsh_value(option));
    if (!option.long_name.empty()) text += fmt::format(" \\\n        '--{}{}", option.long_name, rest);
    if (!option.short_name.empty()) text += fmt::format(" \\\n        '-{}{}", option.short_name, rest);
  }
  return text;
}

std::string zsh_script(const std::vector<CompletionCommand>& commands) {
  std::string text = "#compdef sightline\n# Made by: sightline completion zsh\n_sightline() {\n  local -a commands=(\n";
  for (const CompletionCommand& command : commands) {
    if (!command.name.empty())
      text += fmt::format("    '{}:{}'\n", command.name, quoted_text(command.description, true));
  }
  text += fmt::format(
      "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    compadd -- {}\n    return\n  fi\n"
      "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $command in\n",
      option_words(commands.back()));
  for (const CompletionCommand& command : commands) {
    if (command.name.empty()) continue;
    text +=
        fmt::format("    {})\n      _arguments{} \\\n        '*:file:_files' ;;\n", command.name, zsh_options(command));
  }
  return text + "  esac\n}\n_sightline \"$@\"\n";
}

std::string fish_value(const CompletionOption& option) {
  if (option.follows == Follows::nothing) return "";
  if (option.follows == Follows::folder) return " -x -a '(__fish_complete_directories)'";
  return option.follows == Follows::words ? " -x -a '" + option.words + "'" : " -x";
}

std::string fish_options(const CompletionCommand& command) {
  const std::string condition =
      command.name.empty() ? "__fish_use_subcommand" : fmt::format("__fish_seen_subcommand_from {}", command.name);
  std::string text;
  for (const CompletionOption& option : command.options) {
    text += fmt::format("complete -c sightline -n '{}'", condition);
    if (!option.long_name.empty()) text += " -l " + option.long_name;
    if (!option.short_name.empty()) text += " -s " + option.short_name;
    text += fmt::format("{} -d '{}'\n", fish_value(option), quoted_text(option.description, false));
  }
  return text;
}

std::string fish_script(const std::vector<CompletionCommand>& commands) {
  std::string text = "# Made by: sightline completion fish\n";
  for (const CompletionCommand& command : commands) {
    if (!command.name.empty())
      text += fmt::format("complete -c sightline -n __fish_use_subcommand -f -a {} -d '{}'\n", command.name,
                          quoted_text(command.description, false));
    text += fish_options(command);
  }
  return text;
}

}  // namespace

std::optional<Shell> shell_named(std::string_view name) {
  if (name == "bash") return Shell::bash;
  if (name == "zsh") return Shell::zsh;
  if (name == "fish") return Shell::fish;
  return std::nullopt;
}

std::string completion_script(const CLI::App& app, Shell shell) {
  const std::vector<CompletionCommand> commands = completion_commands(app);
  if (shell == Shell::bash) return bash_script(commands);
  return shell == Shell::zsh ? zsh_script(commands) : fish_script(commands);
}

}  // namespace sightline::cli
