// Every input of fuzz/corpus goes once through the check that the fuzzer runs on it.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "fuzz/checks.h"

namespace sightline::tests::fuzz_corpus_test {
namespace {

std::vector<std::filesystem::path> inputs_of(const std::string& target) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SIGHTLINE_FUZZ_CORPUS_DIR "/" + target)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string content_of(const std::filesystem::path& path) {
  const std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

void check_all(const std::string& target, void (*check)(std::string_view)) {
  const auto files = inputs_of(target);
  REQUIRE(files.size() >= 20);
  for (const auto& file : files) {
    CAPTURE(file.string());
    CHECK_NOTHROW(check(content_of(file)));
  }
}

}  // namespace

TEST_CASE("the fuzzer's OBJ files") { check_all("obj", sightline::fuzz::check_obj); }

TEST_CASE("the fuzzer's meshes of any format") { check_all("mesh", sightline::fuzz::check_mesh); }

TEST_CASE("the fuzzer's scene files") { check_all("scene_file", sightline::fuzz::check_scene_file); }

TEST_CASE("the fuzzer's files of cameras") { check_all("cameras", sightline::fuzz::check_cameras); }

TEST_CASE("the fuzzer's scenes on a grid") { check_all("sweep", sightline::fuzz::check_sweep); }

TEST_CASE("the fuzzer's scenes, cut") { check_all("cutting", sightline::fuzz::check_cutting); }

}  // namespace sightline::tests::fuzz_corpus_test
