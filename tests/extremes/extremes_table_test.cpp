// The README of fixtures/extremes, its files, and the tests name the same scenes.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/tools/command_runner.h"

namespace sightline::tests::extremes_table_test {

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const fs::path folder = SIGHTLINE_FIXTURES_DIR "/extremes";

Names files_ending_with(const std::string& extension) {
  Names names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) names.insert(entry.path().stem().string());
  }
  return names;
}

// Returns what the pattern's first group matches in a text.
Names names_in(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  Names names;
  for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i) names.insert((*i)[1]);
  return names;
}

std::string sources_of_tests() {
  std::string text;
  for (const auto& entry : fs::directory_iterator(SIGHTLINE_FIXTURES_DIR "/../tests/extremes")) {
    if (entry.path().filename().string().rfind("extremes_", 0) == 0) text += sightline::tests::read_text(entry.path());
  }
  return text;
}

}  // namespace

TEST_CASE("the README, the scene files, the meshes and the tests name the same extreme scenes") {
  const Names scenes = files_ending_with(".toml");
  CHECK(scenes.size() >= 27);
  CHECK(files_ending_with(".obj") == scenes);
  CHECK(names_in(sightline::tests::read_text(folder / "README.md"), "\n\\| `(\\w+)` \\| ") == scenes);
  const std::string tests = sources_of_tests();
  CHECK(names_in(tests, "TEST_CASE\\(\"extreme scene (\\w+)[:\"]") == scenes);
  CHECK(names_in(tests, "checked\\(\"(\\w+)\"") == scenes);
}

TEST_CASE("the files of the extreme scenes stay small") {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder)) bytes += entry.is_regular_file() ? entry.file_size() : 0;
  CHECK(bytes <= 4'000'000);
}

}  // namespace sightline::tests::extremes_table_test
