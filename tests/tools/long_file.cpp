#include "tests/tools/long_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <string_view>

namespace sightline::tests {

namespace {

// Ends the process where nobody reads any more.
void write_all(int pipe, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(pipe, text.data(), text.size());
    if (written <= 0) _exit(0);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string repeated_up_to(const std::string& text, std::size_t size) {
  std::string result;
  while (result.size() + text.size() <= size) result += text;
  return result;
}

[[noreturn]] void write_text(const std::filesystem::path& path, const LongText& text) {
  const int pipe = open(path.c_str(), O_WRONLY);
  fcntl(pipe, F_SETPIPE_SZ, 1 << 20);
  write_all(pipe, text.first);
  const std::string chunk = repeated_up_to(text.repeated, 1 << 16);
  for (std::uint64_t done = 0; done < text.repeated_bytes; done += chunk.size()) write_all(pipe, chunk);
  write_all(pipe, text.last);
  _exit(0);
}

}  // namespace

LongFile::LongFile(std::filesystem::path path, const LongText& text) : path_(std::move(path)) {
  if (mkfifo(path_.c_str(), 0600) != 0) throw std::runtime_error("no pipe");
  writer_ = fork();
  if (writer_ == 0) write_text(path_, text);
}

LongFile::~LongFile() {
  kill(writer_, SIGKILL);
  waitpid(writer_, nullptr, 0);
}

}  // namespace sightline::tests
