// The built command is tested from outside: exit codes, what it prints, what it writes.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/cli/result_snapshot.h"
#include "tests/tools/command_runner.h"

namespace sightline::tests::cli_command_test {

using Json = nlohmann::ordered_json;

namespace {

const std::string fang_scene = SIGHTLINE_FIXTURES_DIR "/fang/scene.toml";
const std::string fang_mesh = SIGHTLINE_FIXTURES_DIR "/fang/fang.obj";
const std::vector<std::string> result_files = {"faces.csv",   "labelled.obj", "labelled.ply",
                                               "report.json", "segments.csv", "view.svg"};

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

std::set<std::string> as_set(const std::vector<std::string>& names) { return {names.begin(), names.end()}; }

void check_one_line(const std::string& err) {
  INFO(err);
  CHECK(std::count(err.begin(), err.end(), '\n') == 1);
  CHECK(err.rfind("sightline: ", 0) == 0);
  CHECK(err.back() == '\n');
}

// Leaves out what may differ between runs.
Json without_costs(const std::string& report) {
  Json json = Json::parse(report);
  json.erase("times_s");
  json.erase("peak_memory_bytes");
  return json;
}

std::vector<std::string> mesh_arguments(const std::string& mesh) {
  return {"analyze", mesh, "--eye", "8,8,30", "--target", "8,8,0", "--fov-y", "40"};
}

}  // namespace

TEST_CASE(
    "a scene gives one folder per camera with all files and one file beside them, a summary of 80 columns, and no "
    "error output") {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "deep" / "out").string();
  const RunResult run = run_sightline({"analyze", fang_scene, "-o", out});
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK(names_in(out) == std::set<std::string>{"page", "coverage.csv", "regions.csv"});
  CHECK(names_in(out + "/page") == as_set(result_files));
  CHECK(run.out.find("page/view.svg") != std::string::npos);
  for (const std::string& line : lines_of(run.out)) {
    if (line.find('/') == std::string::npos) CHECK(line.size() <= 80);
  }
}

TEST_CASE("the dial is in the report") {
  const Json by_default = Json::parse(run_sightline({"analyze", fang_scene, "--json"}).out);
  CHECK(by_default["precision"] == Json{{"arithmetic", "unrounded"}});
  const RunResult run = run_sightline({"analyze", fang_scene, "--json", "--arithmetic", "float", "--grid-bits", "20"});
  CHECK(run.exit_code == 0);
  CHECK(Json::parse(run.out)["precision"] == Json{{"arithmetic", "float"}, {"grid_bits", 20}});
}

TEST_CASE("engines and threads write the same files, but for the report") {
  const std::string scene = SIGHTLINE_FIXTURES_DIR "/demo/scene.toml";
  const auto files_of = [&](const std::vector<std::string>& options) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments{"analyze", scene, "--quiet", "-o", folder.path().string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    CHECK(run_sightline(arguments).exit_code == 0);
    Snapshot files = snapshot_of(folder.path());
    std::erase_if(files, [](const auto& file) { return file.first.ends_with("report.json"); });
    return files;
  };
  const Snapshot expected = files_of({"--engine", "full", "--threads", "1"});
  CHECK(expected.size() > 5);
  CHECK(files_of({"--threads", "1"}) == expected);
  CHECK(files_of({"--threads", "2"}) == expected);
  CHECK(files_of({"--threads", "5"}) == expected);
}

TEST_CASE("--json prints the report that is written, and an array for several cameras") {
  const TemporaryFolder folder;
  const RunResult run = run_sightline({"analyze", fang_scene, "--json", "-o", folder.path().string()});
  CHECK(run.exit_code == 0);
  CHECK(run.out == read_text(folder.path() / "page" / "report.json"));
  const std::string two =
      folder.file("two.toml", "[mesh]\nfile = \"" + fang_mesh +
                                  "\"\n[[camera]]\nname = \"a\"\neye = [8, 8, 9]\ntarget = [8, 8, 0]\n"
                                  "orthographic_height = 16\n[[camera]]\nname = \"b\"\n"
                                  "eye = [8, 8, -9]\ntarget = [8, 8, 0]\nfov_y_deg = 90\n");
  const Json reports = Json::parse(run_sightline({"analyze", two, "--json"}).out);
  REQUIRE(reports.size() == 2);
  CHECK(reports[0]["camera"]["name"] == "a");
  CHECK(reports[1]["camera"]["name"] == "b");
  CHECK(reports[0]["camera"]["kind"] == "orthographic");
  CHECK(reports[1]["counts"]["faces"]["back_facing"] == 2);
}

TEST_CASE("--quiet prints nothing, and the camera of the options is called view") {
  const TemporaryFolder folder;
  auto arguments = mesh_arguments(fang_mesh);
  arguments.insert(arguments.end(), {"-o", folder.path().string(), "--quiet"});
  const RunResult run = run_sightline(arguments);
  CHECK(run.exit_code == 0);
  CHECK(run.out.empty());
  CHECK(run.err.empty());
  CHECK(names_in(folder.path() / "view") == as_set(result_files));
}

TEST_CASE("two runs give the same bytes, except for times and memory") {
  const TemporaryFolder first;
  const TemporaryFolder second;
  const std::string demo = SIGHTLINE_FIXTURES_DIR "/demo/scene.toml";
  REQUIRE(run_sightline({"analyze", demo, "-o", first.path().string()}).exit_code == 0);
  REQUIRE(run_sightline({"analyze", demo, "-o", second.path().string()}).exit_code == 0);
  CHECK(names_in(first.path()) == std::set<std::string>{"close-up", "coverage.csv", "front", "regions.csv", "sun"});
  CHECK(read_text(first.path() / "coverage.csv") == read_text(second.path() / "coverage.csv"));
  for (const char* camera : {"close-up", "front", "sun"}) {
    for (const std::string& file : result_files) {
      INFO(camera << "/" << file);
      const std::string a = read_text(first.path() / camera / file);
      const std::string b = read_text(second.path() / camera / file);
      CHECK_FALSE(a.empty());
      const bool same = file == "report.json" ? without_costs(a) == without_costs(b) : a == b;
      CHECK(same);
    }
  }
}

TEST_CASE("results replace older ones and leave other files alone") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "page");
  const std::string other = folder.file("page/notes.txt", "mine");
  folder.file("page/faces.csv", "old");
  CHECK(run_sightline({"analyze", fang_scene, "-o", folder.path().string()}).exit_code == 0);
  CHECK(read_text(other) == "mine");
  CHECK(read_text(folder.path() / "page" / "faces.csv") != "old");
  CHECK(names_in(folder.path()) == std::set<std::string>{"coverage.csv", "page", "regions.csv"});
}

TEST_CASE("wrong input ends with exit code 1 and one line that says where") {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string unknown_key = folder.file("key.toml", "[mesh]\nfile = \"a.obj\"\ncolour = 1\n");
  const std::string no_mesh = folder.file("none.toml",
                                          "[mesh]\nfile = \"no\\nne.obj\"\n[[camera]]\nname = \"a\"\neye = [0, 0, 1]\n"
                                          "target = [0, 0, 0]\nfov_y_deg = 40\n");
  const std::string bad_mesh = folder.file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  const std::string file = folder.file("file", "");
  auto mesh_call = mesh_arguments(bad_mesh);
  mesh_call.insert(mesh_call.end(), {"-o", out});
  const std::vector<std::pair<std::vector<std::string>, std::string>> calls = {
      {{"analyze", unknown_key, "-o", out}, "key.toml:3: unknown key 'colour'"},
      {{"analyze", no_mesh, "-o", out}, "ne.obj"},
      {mesh_call, "bad.obj:4: "},
      {{"analyze", (folder.path() / "missing.toml").string(), "-o", out}, "missing.toml: "},
      {{"analyze", fang_scene, "-o", file}, "cannot be written"},
      {{"analyze", fang_scene, "-o", file + "/below"}, "cannot be written"},
  };
  for (const auto& call : calls) {
    const RunResult run = run_sightline(call.first);
    CHECK(run.exit_code == 1);
    CHECK(run.out.empty());
    check_one_line(run.err);
    CHECK(run.err.find(call.second) != std::string::npos);
  }
  CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("a wrong command line ends with exit code 2 and one line; help and version with 0") {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"analyze"},
                                                    {"analyze", fang_scene},
                                                    {"analyze", fang_mesh, "--json"},
                                                    {"unknown"}}) {
    const RunResult run = run_sightline(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    check_one_line(run.err);
  }
  for (const char* option : {"--help", "--version"}) {
    const RunResult run = run_sightline({option});
    CHECK(run.exit_code == 0);
    CHECK_FALSE(run.out.empty());
    CHECK(run.err.empty());
  }
}

}  // namespace sightline::tests::cli_command_test
