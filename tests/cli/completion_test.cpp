// Shell completion: bash is asked what it would offer, and that is held against the help.
#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "tests/tools/command_runner.h"

namespace sightline::tests::completion_test {

namespace {

using Words = std::set<std::string>;

// Returns what bash offers for the last of the words.
Words offered(const TemporaryFolder& folder, const std::vector<std::string>& words) {
  const std::string script = folder.file("completion.bash", run_sightline({"completion", "bash"}).out);
  std::string line;
  for (const std::string& word : words) line += " '" + word + "'";
  const RunResult result = run_program("/bin/bash", {"-c", "source '" + script + "'; COMP_WORDS=(" + line +
                                                               "); COMP_CWORD=" + std::to_string(words.size() - 1) +
                                                               "; _sightline; printf '%s\\n' \"${COMPREPLY[@]}\""});
  CHECK(result.err == "");
  const auto lines = lines_of(result.out);
  Words result_words(lines.begin(), lines.end());
  result_words.erase("");
  return result_words;
}

// Returns every option that the help of a command has.
Words options_in_help(const std::vector<std::string>& command) {
  const std::string help = run_sightline(command).out;
  const std::string options = help.substr(0, help.find("Example"));
  static const std::regex option("(?:^|[\\s,])(--?[a-z][a-z-]*)(?=[\\s,])");
  Words words;
  for (std::sregex_iterator at(options.begin(), options.end(), option), end; at != end; ++at) words.insert((*at)[1]);
  return words;
}

Words commands_in_help() {
  const std::string help = run_sightline({"--help"}).out;
  const auto begin = std::search(help.begin(), help.end(), std::begin("ubcommands:"), std::end("ubcommands:") - 1);
  static const std::regex command("\n  ([a-z]+) ");
  Words words;
  for (std::sregex_iterator at(begin, help.end(), command), end; at != end; ++at) words.insert((*at)[1]);
  return words;
}

}  // namespace

TEST_CASE("bash offers the commands of the help") {
  const TemporaryFolder folder;
  const Words commands = commands_in_help();
  REQUIRE(commands.contains("analyze"));
  Words all = offered(folder, {"sightline", ""});
  for (const char* option : {"--help", "-h", "--version"}) CHECK(all.erase(option) == 1);
  CHECK(all == commands);
  CHECK(offered(folder, {"sightline", "an"}) == Words{"analyze"});
}

TEST_CASE("bash offers the options of each command's help, and no other") {
  const TemporaryFolder folder;
  for (const std::string& command : commands_in_help()) {
    CAPTURE(command);
    const Words options = options_in_help({command, "--help"});
    REQUIRE(options.contains("--help"));
    CHECK(offered(folder, {"sightline", command, "-"}) == options);
  }
}

TEST_CASE("bash offers what an option takes: words, folders, and nothing behind a number") {
  const TemporaryFolder folder;
  CHECK(offered(folder, {"sightline", "analyze", "--sides", ""}) == Words{"auto", "front", "both"});
  CHECK(offered(folder, {"sightline", "analyze", "--eye", ""}).empty());
  const std::string file = folder.file("scene.toml", "");
  CHECK(offered(folder, {"sightline", "analyze", file.substr(0, file.size() - 3)}) == Words{file});
  CHECK(offered(folder, {"sightline", "analyze", "-o", file.substr(0, file.size() - 3)}).empty());
  CHECK(offered(folder, {"sightline", "analyze", "-o", folder.path().string()}) == Words{folder.path().string()});
}

TEST_CASE("zsh and fish get scripts with every option, too; another shell gets none") {
  for (const char* shell : {"zsh", "fish"}) {
    const std::string script = run_sightline({"completion", shell}).out;
    for (const std::string& option : options_in_help({"analyze", "--help"})) {
      if (!option.starts_with("--")) continue;
      const std::string declared = shell == std::string("zsh") ? "'" + option + "[" : " -l " + option.substr(2) + " ";
      CHECK(script.find(declared) != std::string::npos);
    }
  }
  CHECK(run_sightline({"completion", "csh"}).exit_code == 2);
}

TEST_CASE("the help of each command, and the help that is about none of them, have an example of it") {
  const std::string all = run_sightline({"--help"}).out;
  for (const std::string& command : commands_in_help()) {
    CAPTURE(command);
    const std::string example = "sightline " + command;
    const std::string help = run_sightline({command, "--help"}).out;
    REQUIRE(help.find("Example: ") != std::string::npos);
    CHECK(help.find(example, help.find("Example: ")) != std::string::npos);
    CHECK(all.find(example, all.find("Example: ")) != std::string::npos);
  }
}

}  // namespace sightline::tests::completion_test
