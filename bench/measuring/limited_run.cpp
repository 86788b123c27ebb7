#include "bench/measuring/limited_run.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "cli/system/resources.h"

namespace sightline::bench {
using namespace cli;
namespace {

std::string bytes_of(const std::vector<double>& numbers) {
  std::string bytes(numbers.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::vector<double> numbers_of(const std::string& bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

// These are the runs of one work so far.
struct Runs {
  Outcome::End end = Outcome::End::done;
  std::vector<std::vector<double>> numbers;
  double spent = 0;  // processor seconds
};

void run_again(const Work& work, const RunLimits& limits, Runs& runs) {
  if (runs.end != Outcome::End::done || runs.spent >= limits.seconds) return;
  const ChildrenTime watch;
  Outcome outcome = run_once(work, limits.seconds);
  runs.spent += watch.seconds();
  runs.end = outcome.end;
  runs.numbers.push_back(std::move(outcome.numbers));
}

// Returns the median of each number; the last run has none if it did not end.
std::vector<double> medians(const std::vector<std::vector<double>>& runs) {
  std::vector<double> result;
  for (std::size_t i = 0; i < runs.back().size(); ++i) {
    std::vector<double> values;
    for (const std::vector<double>& run : runs) values.push_back(run[i]);
    std::sort(values.begin(), values.end());
    result.push_back(values[values.size() / 2]);
  }
  return result;
}

}  // namespace

Outcome run_once(const Work& work, double limit_seconds) {
  const SeparateOutcome outcome =
      run_in_separate_process([&work](const LimitedPartDone& /*all*/) { return bytes_of(work()); }, limit_seconds);
  return {outcome.end, numbers_of(outcome.bytes)};
}

std::vector<Outcome> run_in_turns(const std::vector<Work>& works, const RunLimits& limits) {
  std::vector<Runs> runs(works.size());
  for (int turn = 0; turn < limits.runs; ++turn) {
    for (std::size_t i = 0; i < works.size(); ++i) run_again(works[i], limits, runs[i]);
  }
  std::vector<Outcome> outcomes;
  for (const Runs& of_one : runs) outcomes.push_back({of_one.end, medians(of_one.numbers)});
  return outcomes;
}

}  // namespace sightline::bench
