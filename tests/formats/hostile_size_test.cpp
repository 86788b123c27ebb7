// Files may ask for more than there is: they get bounded memory, bounded time, and one line.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "tests/tools/long_file.h"
#include "tests/tools/running_command.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::hostile_size_test {

namespace {

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
constexpr std::uint64_t gibibyte = std::uint64_t{1} << 30;
constexpr std::uint64_t endless = std::numeric_limits<std::uint64_t>::max() / 2;
const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

// A sanitizer keeps memory of its own, and takes its time.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif
constexpr std::uint64_t own_memory = sanitized ? 2 * gibibyte : 0;
constexpr double patience = sanitized ? 10 : 1;

std::vector<std::string> analysis_of(const std::string& mesh, const std::string& max_memory = "512M") {
  return {"analyze", mesh, "--eye=0.3,0.3,5", "--target=0.3,0.3,0", "--fov-y=40", "--json", "--max-memory", max_memory};
}

void check_cost(const Outcome& outcome, std::uint64_t memory, double seconds) {
  CHECK(outcome.peak_memory_bytes < memory + own_memory);
  CHECK(outcome.cpu_seconds < seconds * patience);
}

void check_refused(const Outcome& outcome, const std::string& start, const std::string& part) {
  INFO(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.empty());
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
  CHECK(outcome.err.starts_with("sightline: " + start));
  CHECK(outcome.err.find(part) != std::string::npos);
  CHECK(says_what_to_do(outcome.err));
}

}  // namespace

TEST_CASE("an index beyond any file is refused at once") {
  const TemporaryFolder folder;
  for (const char* index : {"1000000000000", "4294967295", "-1000000000000", "99999999999999999999999999"}) {
    const std::string mesh = folder.file("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf " + std::string(index) + " 2 3\n");
    const Outcome outcome = run_to_end(analysis_of(mesh));
    check_refused(outcome, mesh + ":4: ", index);
    check_cost(outcome, 100 * mebibyte, 2);
  }
}

TEST_CASE("a face with ten million corners is refused at the first too many") {
  const TemporaryFolder folder;
  const LongFile file(folder.path() / "face.obj", {triangle + "f", " 1 2 3", 60000000, "\n"});
  const Outcome outcome = run_to_end(analysis_of(file.path()));
  check_refused(outcome, file.path() + ":5: ", "a face of more than 10000 corners");
  check_cost(outcome, 100 * mebibyte, 2);
}

TEST_CASE("a line of 1 GiB: a comment is passed over, a vertex reads its numbers, a word is refused") {
  const TemporaryFolder folder;
  const LongFile comment(folder.path() / "comment.obj", {"# ", "never ends ", gibibyte, "\n" + triangle});
  const Outcome passed_over = run_to_end(analysis_of(comment.path()));
  CHECK(passed_over.exit_code == 0);
  CHECK(passed_over.err.empty());
  check_cost(passed_over, 100 * mebibyte, 20);
  const LongFile vertex(folder.path() / "vertex.obj", {"v 0 0 0", " 1.5", 64 * mebibyte, "\n" + triangle});
  const Outcome read = run_to_end(analysis_of(vertex.path()));
  CHECK(read.exit_code == 0);
  check_cost(read, 100 * mebibyte, 10);
  const LongFile word(folder.path() / "word.obj", {triangle + "v ", "7", gibibyte, "\n"});
  const Outcome refused = run_to_end(analysis_of(word.path()));
  check_refused(refused, word.path() + ":5: ", "a word of more than 1048576 bytes");
  check_cost(refused, 100 * mebibyte, 2);
}

TEST_CASE("a file of 1 GiB of nothing, and devices that never end, are refused") {
  const TemporaryFolder folder;
  const std::string sparse = folder.file("sparse.obj", triangle);
  std::filesystem::resize_file(sparse, gibibyte);
  const Outcome nothing = run_to_end(analysis_of(sparse));
  check_refused(nothing, sparse + ":5: ", "a word of more than");
  check_cost(nothing, 100 * mebibyte, 2);
  const Outcome zeros = run_to_end(analysis_of("/dev/zero"));
  check_refused(zeros, "/dev/zero:1: ", "a word of more than");
  check_cost(zeros, 100 * mebibyte, 2);
  std::filesystem::create_symlink("/dev/zero", folder.path() / "zero.toml");
  const Outcome scene = run_to_end({"analyze", (folder.path() / "zero.toml").string(), "--json"});
  check_refused(scene, (folder.path() / "zero.toml").string() + ": ", "more than 67108864 bytes");
  check_cost(scene, 300 * mebibyte, 2);
}

TEST_CASE("vertices and faces without end stop at the limit, with both numbers") {
  const TemporaryFolder folder;
  for (const char* statement : {"v 1 2 3\n", "f 1 2 3\n", "f 1\n", "f\n"}) {
    const LongFile file(folder.path() / "endless.obj", {triangle, statement, endless, ""});
    const Outcome outcome = run_to_end(analysis_of(file.path(), "100M"));
    check_refused(outcome, file.path() + ":",
                  " bytes of memory, and the limit is 104857600; raise it with --max-memory");
    check_cost(outcome, 100 * mebibyte, 10);
    std::filesystem::remove(file.path());
  }
}

namespace {

// There is one in each cell of a square whose rows climb a little, so that few are at one height; no two share a corner.
std::string lone_triangles(std::size_t cells) {
  std::string text;
  for (std::size_t i = 0; i < cells; ++i) {
    for (std::size_t j = 0; j < cells; ++j) {
      const std::string x = std::to_string(i);
      const auto y = [&](std::size_t thousandths) { return std::to_string(j) + "." + std::to_string(thousandths + i); };
      text +=
          "v " + x + " " + y(100) + " 0\nv " + x + ".5 " + y(300) + " 0\nv " + x + " " + y(600) + " 0\nf -3 -2 -1\n";
    }
  }
  return text;
}

// Two layers of needles lie across each other: they make count^2 crossings, all of them visible.
std::string woven_needles(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string low = std::to_string(2 * i);
    const std::string high = std::to_string(2 * i + 1);
    const std::string end = std::to_string(2 * count);
    text += "v " + low + " 0 0\nv " + high + " 0 0\nv " + low + " " + end + " 0\n";
    text += "v 0 " + low + " 1\nv " + end + " " + low + " 1\nv 0 " + high + " 1\n";
  }
  for (std::size_t i = 0; i < 6 * count; i += 3)
    text += "f " + std::to_string(i + 1) + " " + std::to_string(i + 2) + " " + std::to_string(i + 3) + "\n";
  return text;
}

std::vector<std::string> view_from_above(const std::string& mesh, std::size_t size, const std::string& max_memory) {
  const std::string middle = std::to_string(size / 2) + "," + std::to_string(size / 2);
  return {"analyze",
          mesh,
          "--eye=" + middle + "," + std::to_string(2 * size),
          "--target=" + middle + ",0",
          "--fov-y=60",
          "--json",
          "--max-memory",
          max_memory};
}

}  // namespace

TEST_CASE("a view that needs more than the limit is refused before its sweep, with both numbers") {
  const TemporaryFolder folder;
  const std::string mesh = folder.file("triangles.obj", lone_triangles(280));
  const Outcome refused = run_to_end(view_from_above(mesh, 280, "96M"));
  check_refused(refused, "camera \"view\" needs about ", "MiB of memory, and the limit is 96.0 MiB");
  check_cost(refused, 96 * mebibyte, 10);
  CHECK(run_to_end(view_from_above(mesh, 280, "2G")).exit_code == 0);
}

TEST_CASE("what no count foretells, crossings without number, stops at the limit, with both numbers") {
  const TemporaryFolder folder;
  const std::string mesh = folder.file("needles.obj", woven_needles(500));
  const Outcome refused = run_to_end(view_from_above(mesh, 1000, "80M"));
  // With a sanitizer the limit does not hold.
  if (sanitized) return;
  check_refused(refused, "more memory is needed: ", "are in use, and the limit is 80.0 MiB");
  check_cost(refused, 80 * mebibyte, 30);
}

}  // namespace sightline::tests::hostile_size_test
