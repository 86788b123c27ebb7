// Cleaning up when the user or the system ends the process.
//
// While a SignalWatch lives, SIGINT, SIGTERM and SIGHUP run `clean_up` in a thread that waits for them, and then end the
// process as the signal would have ended it (a shell sees 130, 143, 129). A signal that the process was started to
// ignore (nohup) stays ignored.
// Why a thread and not a handler: the signals are blocked in every other thread, so `clean_up` interrupts nothing and may
// do what any code may, lists and locks included. A handler may call little more than unlink; a flag that the stages poll
// would let a long stage go on.
// Holds: one at a time, made before other threads are, so that these inherit the blocked signals; when it is gone, the
// signals act as before.
#pragma once

#include <csignal>
#include <functional>
#include <thread>

namespace sightline::cli {

class SignalWatch {
 public:
  // clean_up must return soon.
  explicit SignalWatch(std::function<void()> clean_up);
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  ~SignalWatch();

 private:
  void wait();

  std::function<void()> clean_up_;
  sigset_t waited_for_;
  sigset_t mask_before_;
  std::thread thread_;
};

}  // namespace sightline::cli
