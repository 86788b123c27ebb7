// Shell completion, made from the declared options, so that it offers what there is and nothing else.
//
// In:  the command line's declaration. Out: a script for bash, zsh or fish that completes commands, options, their values
//      where these are words that the help lists (a|b|c) or folders (DIR), and else files.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sightline::cli {

enum class Shell : std::uint8_t { bash, zsh, fish };

[[nodiscard]] std::optional<Shell> shell_named(std::string_view name);

[[nodiscard]] std::string completion_script(const CLI::App& app, Shell shell);

}  // namespace sightline::cli
