// As long as it lives no file can be opened, and opened() tells whether somebody tried last.
#pragma once

#include <sys/resource.h>

#include <cerrno>

namespace sightline::fuzz {

class NoFiles {
 public:
  NoFiles() {
    getrlimit(RLIMIT_NOFILE, &before_);
    rlimit none = before_;
    none.rlim_cur = 0;
    setrlimit(RLIMIT_NOFILE, &none);
    errno = 0;
  }
  ~NoFiles() { setrlimit(RLIMIT_NOFILE, &before_); }
  NoFiles(const NoFiles&) = delete;
  NoFiles& operator=(const NoFiles&) = delete;

  // The last system call that failed since then failed for want of file descriptors.
  [[nodiscard]] static bool was_tried() { return errno == EMFILE; }

 private:
  rlimit before_{};
};

}  // namespace sightline::fuzz
