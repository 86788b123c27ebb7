#include "cli/system/durable_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace sightline::cli {

void fail_to_write(const std::filesystem::path& path, int error) {
  throw OutputError(path.string() + ": cannot be written: " + std::generic_category().message(error) +
                    "; choose another folder with -o");
}

Descriptor::~Descriptor() {
  if (valid()) close(number_);
}

Descriptor create_file(const std::filesystem::path& path) {
  Descriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!file.valid()) fail_to_write(path, errno);
  return file;
}

void write_all(const Descriptor& file, std::string_view content, const std::filesystem::path& path) {
  while (!content.empty()) {
    const ssize_t written = write(file.number(), content.data(), content.size());
    if (written < 0 && errno != EINTR) fail_to_write(path, errno);
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
}

void sync_file(const Descriptor& file, const std::filesystem::path& path) {
  if (fsync(file.number()) != 0) fail_to_write(path, errno);
}

// Some file systems cannot sync a folder, and say EINVAL.
void sync_folder(const std::filesystem::path& folder) {
  const Descriptor opened(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!opened.valid()) fail_to_write(folder, errno);
  if (fsync(opened.number()) != 0 && errno != EINVAL) fail_to_write(folder, errno);
}

}  // namespace sightline::cli
