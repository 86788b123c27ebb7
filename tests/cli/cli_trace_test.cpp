// `sightline trace` is tested as a command: its log and page, and what it refuses.
#include <doctest/doctest.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/trace/trace_examples.h"
#include "tests/tools/command_runner.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::cli_trace_test {
using namespace cli;

namespace {

const std::string fang_scene = SIGHTLINE_FIXTURES_DIR "/fang/scene.toml";

// Returns a sheet of n x n vertices.
std::string sheet(int n) {
  std::string obj;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) obj += fmt::format("v {} {} 0\n", x, y);
  }
  for (int y = 0; y + 1 < n; ++y) {
    for (int x = 1; x < n; ++x) {
      const int low = y * n + x;
      obj += fmt::format("f {} {} {} {}\n", low, low + 1, low + n + 1, low + n);
    }
  }
  return obj;
}

const char* const two_cameras = R"([mesh]
file = "sheet.obj"
[[camera]]
name = "all"
eye = [40, 40, 100]
target = [40, 40, 0]
up = [0, 1, 0]
orthographic_height = 100.0
[[camera]]
name = "near"
eye = [10, 10, 100]
target = [10, 10, 0]
up = [0, 1, 0]
orthographic_height = 5.0
)";

}  // namespace

TEST_CASE("trace command: the log of Fang's example is the golden one, byte for byte, and a run leaves nothing else") {
  const TemporaryFolder folder;
  const std::string log = folder.path() / "fang.json";
  const RunResult run = tests::run_sightline({"trace", "--example", "fang", "--log", log});
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK(run.out == "exact: 12 sweep points, 14 visible segments\n" + log + "\n");
  CHECK(tests::read_text(log) == tests::read_text(SIGHTLINE_FIXTURES_DIR "/../tests/golden/fang_trace.json"));
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("trace command: the scene file says the same as the example, under other names") {
  const TemporaryFolder folder;
  const std::string log = folder.path() / "fang.json";
  REQUIRE(tests::run_sightline({"trace", fang_scene, "--log", log}).exit_code == 0);
  const auto json = nlohmann::json::parse(tests::read_text(log));
  CHECK(json["camera"] == "page");
  const auto golden =
      nlohmann::json::parse(tests::read_text(SIGHTLINE_FIXTURES_DIR "/../tests/golden/fang_trace.json"));
  REQUIRE(json["sweeps"].size() == 1);
  for (const char* same : {"edges", "facets"}) CHECK(json["sweeps"][0][same] == golden["sweeps"][0][same]);
  CHECK(json["sweeps"][0]["steps"].size() == 12);
  CHECK(json["sweeps"][0]["steps"][0]["name"] == "v6");
  CHECK(json["sweeps"][0]["steps"][2]["name"] == "x1");
}

TEST_CASE("trace command: an arithmetic that is not exact has exact beside it") {
  const TemporaryFolder folder;
  const std::string log = folder.path() / "log.json";
  REQUIRE(tests::run_sightline({"trace", fang_scene, "--log", log, "--arithmetic", "float"}).exit_code == 0);
  const auto json = nlohmann::json::parse(tests::read_text(log));
  REQUIRE(json["sweeps"].size() == 2);
  CHECK(json["sweeps"][0]["arithmetic"] == "float");
  CHECK(json["sweeps"][1]["arithmetic"] == "exact");
}

TEST_CASE("trace command: more than 5000 sweep points are refused with the number and what to do") {
  const TemporaryFolder folder;
  folder.file("sheet.obj", sheet(72));
  const std::string scene = folder.file("scene.toml", two_cameras);
  const std::string log = folder.path() / "log.json";
  const RunResult all = tests::run_sightline({"trace", scene, "--camera", "all", "--log", log});
  CHECK(all.exit_code == 1);
  CHECK(all.err.find("camera 'all' has 5184 points in view") != std::string::npos);
  CHECK(all.err.find("5000") != std::string::npos);
  CHECK(all.err.find("narrower fov_y") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(log));
  // The other camera crops it.
  CHECK(tests::run_sightline({"trace", scene, "--camera", "near", "--log", log}).exit_code == 0);
  CHECK(nlohmann::json::parse(tests::read_text(log))["camera"] == "near");
}

TEST_CASE("trace command: what is wrong with a command line is said in one line") {
  const TemporaryFolder folder;
  folder.file("sheet.obj", sheet(3));
  const std::string scene = folder.file("scene.toml", two_cameras);
  const std::string log = folder.path() / "log.json";
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"trace", scene, "--log", log}, "choose one with --camera, of all, near"},
      {{"trace", scene, "--log", log, "--camera", "none"}, "the scene has no 'none'"},
      {{"trace", scene}, "give -o FILE"},
      {{"trace", "--log", log}, "give a scene file, or --example"},
      {{"trace", scene, "--example", "fang", "--log", log}, "not both"},
      {{"trace", "mesh.obj", "--log", log}, "not a scene file"},
      {{"trace", "--example", "none", "--log", log}, "there is no 'none'"},
      {{"trace", "--example", "fang", "--log", log, "--camera", "all"}, "an example has its own"},
      {{"trace", "--example", "fang", "--log", log, "--arithmetic", "half"}, "not float, double"},
      {{"trace", "--example", "fang", "--log", log, "--arithmetic", "unrounded"}, "choose float, double or exact"},
      {{"trace", scene, "--log", log, "--camera", "all", "--sides", "inner"}, "not auto, front or both"}};
  for (const auto& [arguments, words] : cases) {
    const RunResult run = tests::run_sightline(arguments);
    INFO(run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.err.find(words) != std::string::npos);
    CHECK(says_what_to_do(run.err));
    CHECK(tests::lines_of(run.err).size() == 1);
  }
  CHECK_FALSE(std::filesystem::exists(log));
}

TEST_CASE("trace command: a file that cannot be written is an error, and an old one stays") {
  const TemporaryFolder folder;
  const RunResult run =
      tests::run_sightline({"trace", "--example", "fang", "--log", folder.path() / "no" / "log.json"});
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("cannot be written") != std::string::npos);
  std::filesystem::create_directory(folder.path() / "folder");
  CHECK(tests::run_sightline({"trace", "--example", "fang", "--log", folder.path() / "folder"}).exit_code == 1);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("trace command: --list names every built-in scene") {
  const RunResult run = tests::run_sightline({"trace", "--list"});
  CHECK(run.exit_code == 0);
  const auto lines = tests::lines_of(run.out);
  REQUIRE(lines.size() == trace_examples().size());
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i].starts_with(trace_examples()[i].name + " "));
}

}  // namespace sightline::tests::cli_trace_test
