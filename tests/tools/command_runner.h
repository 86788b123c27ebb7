// This runs the built command, and has folders that go away afterwards.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sightline::tests {

class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Writes a file in it and returns its path.
  std::string file(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

struct RunResult {
  int exit_code = 0;  // 1000 + the signal's number where a signal ended it
  std::string out;
  std::string err;
};

[[nodiscard]] RunResult run_program(const std::string& program, const std::vector<std::string>& arguments);

// Runs SIGHTLINE_COMMAND with the arguments.
[[nodiscard]] RunResult run_sightline(const std::vector<std::string>& arguments);

[[nodiscard]] std::string read_text(const std::filesystem::path& file);
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

}  // namespace sightline::tests
