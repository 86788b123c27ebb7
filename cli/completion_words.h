// What there is to complete: commands, their options, and what goes behind these.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace sightline::cli {

// What follows an option.
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

// The last one has no name: the options without a command.
[[nodiscard]] std::vector<CompletionCommand> completion_commands(const CLI::App& app);

// "--name -n", for the options of a command.
[[nodiscard]] std::string option_words(const CompletionCommand& command);

}  // namespace sightline::cli
