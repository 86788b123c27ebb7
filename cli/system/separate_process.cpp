#include "cli/system/separate_process.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string_view>
#include <system_error>

#include "cli/system/memory_limit.h"

namespace sightline::cli {

namespace {

constexpr int milliseconds_between_looks = 20;
constexpr char limited_part_done = 'd';

// The recursion of some work is deep, and its hunger for memory must not take the machine down.
void limit_this_process() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  rlimit stack{};
  getrlimit(RLIMIT_STACK, &stack);
  stack.rlim_cur = stack.rlim_max;
  setrlimit(RLIMIT_STACK, &stack);
  hold_to(default_memory_limit());
}

bool write_all(int pipe_end, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(pipe_end, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// Ends without the clean-up that is the parent's to do.
[[noreturn]] void be_child(const SeparateWork& work, int pipe_end) {
  try {
    limit_this_process();
    bool is_told = false;
    const LimitedPartDone tell = [&] { is_told = is_told || write_all(pipe_end, {&limited_part_done, 1}); };
    const std::string bytes = work(tell);
    tell();
    _exit(write_all(pipe_end, bytes) ? 0 : 1);
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
bool writes_in_time(int pipe_end, pid_t child, double limit_seconds) {
  pollfd watched{pipe_end, POLLIN, 0};
  while (poll(&watched, 1, milliseconds_between_looks) <= 0) {
    if (processor_seconds(child) < limit_seconds) continue;
    kill(child, SIGKILL);
    return false;
  }
  return true;
}

std::string read_all(int pipe_end) {
  std::string bytes;
  std::array<char, 1 << 16> buffer{};
  while (true) {
    const ssize_t count = read(pipe_end, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

bool ended_well(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

SeparateOutcome run_in_separate_process(const SeparateWork& work, double limit_seconds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(nullptr);  // else the child would write what is in the buffers again
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) be_child(work, ends[1]);
  close(ends[1]);
  const bool in_time = writes_in_time(ends[0], child, limit_seconds);
  std::string bytes = read_all(ends[0]);
  close(ends[0]);
  const bool well = ended_well(child);
  if (!in_time) return {SeparateOutcome::End::out_of_time, {}};
  if (!well || bytes.empty()) return {SeparateOutcome::End::failed, {}};
  return {SeparateOutcome::End::done, bytes.substr(1)};
}

}  // namespace sightline::cli
