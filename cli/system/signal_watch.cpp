#include "cli/system/signal_watch.h"

#include <pthread.h>
#include <unistd.h>

#include <exception>

namespace sightline::cli {

namespace {

// Nobody else sends the process a real-time signal.
int stop_signal() { return SIGRTMIN; }

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

sigset_t signals_to_wait_for() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!is_ignored(signal)) sigaddset(&set, signal);
  }
  sigaddset(&set, stop_signal());
  return set;
}

[[noreturn]] void end_process(int signal) {
  sigset_t only_this;
  sigemptyset(&only_this);
  sigaddset(&only_this, signal);
  pthread_sigmask(SIG_UNBLOCK, &only_this, nullptr);
  std::raise(signal);
  _exit(128 + signal);
}

}  // namespace

SignalWatch::SignalWatch(std::function<void()> clean_up)
    : clean_up_(std::move(clean_up)), waited_for_(signals_to_wait_for()), mask_before_() {
  pthread_sigmask(SIG_BLOCK, &waited_for_, &mask_before_);
  thread_ = std::thread([this] { wait(); });
}

SignalWatch::~SignalWatch() {
  pthread_kill(thread_.native_handle(), stop_signal());
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

void SignalWatch::wait() {
  int signal = 0;
  while (sigwait(&waited_for_, &signal) != 0) {
  }
  if (signal == stop_signal()) return;
  try {
    clean_up_();
  } catch (const std::exception&) {  // no memory left for it: the process ends all the same
  }
  end_process(signal);
}

}  // namespace sightline::cli
