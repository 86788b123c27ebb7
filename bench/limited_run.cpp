#include "bench/limited_run.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <system_error>
#include <utility>

#include "bench/processor_time.h"

namespace sightline::bench {
namespace {

constexpr int milliseconds_between_looks = 20;

// The recursion of some rivals is deep, and their hunger for memory must not take the machine down.
void limit_this_process() {
  rlimit stack{};
  getrlimit(RLIMIT_STACK, &stack);
  stack.rlim_cur = stack.rlim_max;
  setrlimit(RLIMIT_STACK, &stack);
  const auto memory = static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  const rlimit most{memory / 4 * 3, memory / 4 * 3};
  setrlimit(RLIMIT_AS, &most);
}

// Ends without the clean-up that is the parent's to do.
[[noreturn]] void be_child(const Work& work, int pipe_end) {
  try {
    limit_this_process();
    const std::vector<double> numbers = work();
    const auto bytes = static_cast<ssize_t>(numbers.size() * sizeof(double));
    _exit(write(pipe_end, numbers.data(), static_cast<std::size_t>(bytes)) == bytes ? 0 : 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    _exit(1);
  }
}

double processor_seconds(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Waits until the child writes or ends; false: it was ended, for its time was up. A timer in the child would do that
// too, but where one runs Linux advances the child's own processor clock in steps of milliseconds only.
bool ends_in_time(int pipe_end, pid_t child, double limit_seconds) {
  pollfd watched{pipe_end, POLLIN, 0};
  while (poll(&watched, 1, milliseconds_between_looks) <= 0) {
    if (processor_seconds(child) < limit_seconds) continue;
    kill(child, SIGKILL);
    return false;
  }
  return true;
}

std::vector<double> read_numbers(int pipe_end) {
  std::array<double, 64> buffer{};
  const ssize_t bytes = read(pipe_end, buffer.data(), sizeof buffer);
  const std::size_t count = bytes > 0 ? static_cast<std::size_t>(bytes) / sizeof(double) : 0;
  return {buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count)};
}

bool ended_well(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// The runs of one work so far.
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

// Of each number; of the last run none are there if it did not end.
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
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(nullptr);  // else the child would write what is in the buffers again
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) be_child(work, ends[1]);
  close(ends[1]);
  const bool in_time = ends_in_time(ends[0], child, limit_seconds);
  std::vector<double> numbers = in_time ? read_numbers(ends[0]) : std::vector<double>{};
  close(ends[0]);
  const bool well = ended_well(child);
  if (!in_time) return {Outcome::End::out_of_time, {}};
  return {well ? Outcome::End::done : Outcome::End::failed, std::move(numbers)};
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
