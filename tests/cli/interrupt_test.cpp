// Signals come at random moments: the folder of results is the old one or the new one, never half.
#include <doctest/doctest.h>

#include <array>
#include <csignal>
#include <random>
#include <thread>

#include "tests/cli/result_snapshot.h"
#include "tests/tools/running_command.h"

namespace sightline::tests::interrupt_test {

namespace {

namespace fs = std::filesystem;

constexpr int kills_per_signal = 100;

// Two scenes take turns in one folder: whichever is there is the old result of the next run.
struct TakingTurns {
  TemporaryFolder folder;
  fs::path results = folder.path() / "results";
  std::array<std::string, 2> scenes{folder.file("a.toml", three_camera_scene(0)),
                                    folder.file("b.toml", three_camera_scene(1))};
  std::array<Snapshot, 2> expected;
  double seconds = 0;  // of one run
  int current = 0;

  TakingTurns() {
    for (const std::size_t i : {1U, 0U}) {
      const Outcome outcome = run_to_end(arguments(static_cast<int>(i)));
      REQUIRE(outcome.exit_code == 0);
      seconds = outcome.seconds;
      if (i == 1) folder.file("results/near/notes.txt", "mine");
      expected[i] = snapshot_of(results);
    }
    REQUIRE(expected[0].size() == 21);
    REQUIRE(expected[0] != expected[1]);
  }

  [[nodiscard]] std::vector<std::string> arguments(int scene) const {
    return {"analyze", scenes[static_cast<std::size_t>(scene)], "--quiet", "-o", results.string()};
  }
  [[nodiscard]] const Snapshot& old_result() const { return expected[static_cast<std::size_t>(current)]; }
  [[nodiscard]] const Snapshot& new_result() const { return expected[static_cast<std::size_t>(1 - current)]; }
};

struct Tally {
  int old_result = 0;
  int new_result = 0;
  int left_over = 0;
};

void sleep_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

void wait_for_leftover(const fs::path& folder, double at_most) {
  for (double waited = 0; leftovers_in(folder) == 0 && waited < at_most; waited += 1e-4) sleep_for(1e-4);
}

// Every other kill is aimed at the time of writing, which is short.
Outcome killed_run(const TakingTurns& turns, int signal, bool while_writing, double moment) {
  RunningCommand command(turns.arguments(1 - turns.current));
  if (while_writing) wait_for_leftover(turns.results, 2 * turns.seconds);
  sleep_for(moment * turns.seconds);
  command.send(signal);
  return command.wait();
}

// Each of the folders, and the file beside them, is one or the other.
bool every_one_is_old_or_new(const Snapshot& seen, const Snapshot& a, const Snapshot& b) {
  const auto part = [](const Snapshot& all, const std::string& name) {
    Snapshot result;
    for (const auto& [path, text] : all) {
      if (path.starts_with(name)) result[path] = text;
    }
    return result;
  };
  for (const char* name : {"near/", "far/", "sun/", "coverage.csv", "regions.csv"}) {
    if (part(seen, name) != part(a, name) && part(seen, name) != part(b, name)) return false;
  }
  return seen.size() == a.size();
}

void kill_once(TakingTurns& turns, int signal, bool while_writing, double moment, Tally& tally) {
  const std::size_t leftovers = leftovers_in(turns.results);
  const Outcome outcome = killed_run(turns, signal, while_writing, moment);
  INFO("signal " << signal << (while_writing ? " while writing" : "") << " after " << moment << " of a run");
  const bool ends_as_it_should = outcome.exit_code == 0 || outcome.exit_code == 1000 + signal;
  CHECK(ends_as_it_should);
  const Snapshot seen = snapshot_of(turns.results);
  const bool is_new = seen == turns.new_result();
  const bool is_old = seen == turns.old_result();
  if (outcome.exit_code == 0) CHECK(is_new);
  if (signal == SIGKILL) {
    CHECK(every_one_is_old_or_new(seen, turns.old_result(), turns.new_result()));
    tally.left_over += leftovers_in(turns.results) > 0 ? 1 : 0;
  } else {
    CHECK((is_new || is_old));
    CHECK(leftovers_in(turns.results) <= leftovers);
  }
  tally.old_result += is_old ? 1 : 0;
  tally.new_result += is_new ? 1 : 0;
  if (is_new) turns.current = 1 - turns.current;
}

Tally kill_often(TakingTurns& turns, int signal) {
  const unsigned seed = std::random_device{}();
  MESSAGE("signal " << signal << ", seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> moment(0, 1.1);
  Tally tally;
  for (int i = 0; i < kills_per_signal; ++i) {
    const bool while_writing = i % 2 == 1;
    kill_once(turns, signal, while_writing, while_writing ? moment(random) / 2 : moment(random), tally);
    if (signal != SIGKILL || leftovers_in(turns.results) == 0) continue;
    REQUIRE(run_to_end(turns.arguments(turns.current)).exit_code == 0);
    CHECK(leftovers_in(turns.results) == 0);
    CHECK(snapshot_of(turns.results) == turns.old_result());
  }
  MESSAGE(kills_per_signal << " signals: " << tally.old_result << " left the old result, " << tally.new_result
                           << " the new one; " << tally.left_over << " left a temporary folder");
  CHECK(tally.old_result > 0);
  CHECK(tally.new_result > 0);
  return tally;
}

}  // namespace

TEST_CASE("SIGINT and SIGTERM at any moment leave the old result or the new one, and nothing else") {
  TakingTurns turns;
  for (const int signal : {SIGINT, SIGTERM}) (void)kill_often(turns, signal);
  CHECK(leftovers_in(turns.results) == 0);
}

TEST_CASE(
    "SIGKILL at any moment leaves every folder, and the file beside them, old or new, and the next run cleans up") {
  TakingTurns turns;
  CHECK(kill_often(turns, SIGKILL).left_over > 0);
}

TEST_CASE("a signal leaves no folder that was not there before") {
  const TakingTurns turns;
  const fs::path fresh = turns.folder.path() / "deep" / "fresh";
  std::vector<std::string> arguments = turns.arguments(0);
  arguments.back() = fresh.string();
  RunningCommand command(arguments);
  for (int i = 0; i < 100000 && !fs::exists(fresh); ++i) sleep_for(1e-5);
  REQUIRE(fs::exists(fresh));
  command.send(SIGTERM);
  if (command.wait().exit_code == 1000 + SIGTERM) CHECK_FALSE(fs::exists(fresh.parent_path()));
}

TEST_CASE("a signal that the command was started to ignore does not end it") {
  const TakingTurns turns;
  RunningCommand command(turns.arguments(1), {.ignores_interrupts = true});
  for (int i = 0; i < 20; ++i) {
    sleep_for(turns.seconds / 20);
    command.send(SIGINT);
  }
  CHECK(command.wait().exit_code == 0);
  CHECK(snapshot_of(turns.results) == turns.new_result());
}

}  // namespace sightline::tests::interrupt_test
