// Files may be larger than a disk should hold: a named pipe that another process writes to.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace sightline::tests {

// The text is `first`, then `repeated` until so many bytes of it are written, then `last`.
struct LongText {
  std::string first;
  std::string repeated;
  std::uint64_t repeated_bytes = 0;
  std::string last;
};

class LongFile {
 public:
  // Makes the pipe; whoever opens it for reading gets the text once.
  LongFile(std::filesystem::path path, const LongText& text);
  LongFile(const LongFile&) = delete;
  LongFile& operator=(const LongFile&) = delete;
  ~LongFile();

  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
  pid_t writer_ = 0;
};

}  // namespace sightline::tests
