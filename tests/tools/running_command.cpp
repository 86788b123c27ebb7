#include "tests/tools/running_command.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace sightline::tests {

namespace {

void redirect(const std::filesystem::path& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(126);
}

void apply(const ProcessLimits& limits) {
  const rlimit file_size{limits.file_size, limits.file_size};
  if (setrlimit(RLIMIT_FSIZE, &file_size) != 0) _exit(126);
  std::signal(SIGINT, limits.ignores_interrupts ? SIG_IGN : SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

// Signals wait as long as this lives: the tests' own handlers are the child's, too, until it has its own.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, &before_);
  }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
  ~SignalsHeld() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

[[noreturn]] void execute(const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>(SIGHTLINE_COMMAND)};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execv(SIGHTLINE_COMMAND, words.data());
  _exit(127);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

RunningCommand::RunningCommand(const std::vector<std::string>& arguments, const ProcessLimits& limits)
    : start_(std::chrono::steady_clock::now()) {
  {
    const SignalsHeld held;
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("no new process");
    if (process_ > 0) return;
    redirect(folder_.path() / "out", STDOUT_FILENO);
    redirect(folder_.path() / "err", STDERR_FILENO);
    apply(limits);
  }
  execute(arguments);
}

RunningCommand::~RunningCommand() {
  if (process_ <= 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void RunningCommand::send(int signal) const { kill(process_, signal); }

Outcome RunningCommand::wait() {
  int status = 0;
  rusage usage{};
  wait4(process_, &status, 0, &usage);
  process_ = 0;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status),
          read_text(folder_.path() / "out"),
          read_text(folder_.path() / "err"),
          seconds_since(start_),
          seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
          static_cast<std::uint64_t>(usage.ru_maxrss) * 1024};
}

}  // namespace sightline::tests
