#include "cli/output_folder.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace sightline {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& cause) {
  throw OutputError(path.string() + ": cannot be written: " + cause + "; choose another folder with -o");
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail(folder, error.message());
}

}  // namespace

OutputFolder::OutputFolder(const std::filesystem::path& parent, const std::string& name)
    : folder_(parent / name), temporary_(parent / ("." + name + ".partial-" + std::to_string(getpid()))) {
  make_folder(folder_);
  make_folder(temporary_);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  for (const std::string& file : files_) std::filesystem::remove(temporary_ / file, ignored);
  std::filesystem::remove(temporary_, ignored);
}

void OutputFolder::write(const std::string& file, std::string_view content) {
  files_.push_back(file);
  const std::filesystem::path path = temporary_ / file;
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) fail(path, std::strerror(errno));
}

void OutputFolder::publish() {
  for (const std::string& file : files_) {
    std::error_code error;
    std::filesystem::rename(temporary_ / file, folder_ / file, error);
    if (error) fail(folder_ / file, error.message());
  }
  files_.clear();
}

}  // namespace sightline
