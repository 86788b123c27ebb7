#include "cli/system/staging_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>

namespace sightline::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = ".sightline-partial-";

// The folder and its parents, as far as they are not there, the outermost first.
std::vector<fs::path> missing_folders(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path at = fs::absolute(folder, error); !fs::exists(at, error) && at.has_relative_path();
       at = at.parent_path()) {
    if (at.has_filename()) missing.insert(missing.begin(), at);
  }
  return missing;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_to_write(folder, error.value());
}

void remove_empty(const std::vector<fs::path>& folders) {
  std::for_each(folders.rbegin(), folders.rend(), [](const fs::path& folder) { rmdir(folder.c_str()); });
}

Descriptor opened_folder(const fs::path& folder) {
  return Descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

bool has_name(const Descriptor& folder) {
  struct stat status {};
  return fstat(folder.number(), &status) == 0 && status.st_nlink > 0;
}

// Puts back what a run that was killed between two renames had moved away from its place.
void restore_old_results(const fs::path& leftover, const fs::path& parent) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(leftover / "old", ignored)) {
    const fs::path place = parent / entry.path().filename();
    if (!fs::exists(fs::symlink_status(place, ignored))) fs::rename(entry.path(), place, ignored);
  }
}

void remove_leftovers(const fs::path& parent) {
  std::error_code ignored;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, ignored)) {
    if (entry.path().filename().string().starts_with(prefix)) found.push_back(entry.path());
  }
  for (const fs::path& path : found) {
    const Descriptor folder = opened_folder(path);
    if (!folder.valid() || flock(folder.number(), LOCK_EX | LOCK_NB) != 0) continue;
    restore_old_results(path, parent);
    fs::remove_all(path, ignored);
  }
}

fs::path fresh_folder(const fs::path& parent) {
  std::string path = (parent / (std::string(prefix) + "XXXXXX")).string();
  if (mkdtemp(path.data()) == nullptr) fail_to_write(parent, errno);
  return path;
}

// Invalid where another run took the folder for a leftover before it was locked.
Descriptor lock_of(const fs::path& folder) {
  Descriptor opened = opened_folder(folder);
  if (!opened.valid()) return opened;
  const bool is_taken = flock(opened.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  return is_taken || !has_name(opened) ? Descriptor() : std::move(opened);
}

}  // namespace

StagingFolder::StagingFolder()
    : watch_([this] {
        names_.lock();
        remove();
      }) {}

// From here on the destructor cleans up, also where this throws.
StagingFolder::StagingFolder(const fs::path& parent) : StagingFolder() {
  const auto names = this->names();
  made_ = missing_folders(parent);
  make_folder(parent);
  remove_leftovers(parent);
  while (!lock_.valid()) {
    path_ = fresh_folder(parent);
    lock_ = lock_of(path_);
  }
  for (const fs::path& folder : {fresh(), old()}) {
    if (mkdir(folder.c_str(), 0777) != 0) fail_to_write(folder, errno);
  }
}

StagingFolder::~StagingFolder() {
  const auto names = this->names();
  remove();
}

void StagingFolder::remove() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  remove_empty(made_);
}

}  // namespace sightline::cli
