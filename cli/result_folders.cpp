#include "cli/result_folders.h"

#include <cerrno>
#include <vector>

#include "cli/foreign_files.h"

namespace sightline {

namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(fs::symlink_status(path, ignored));
}

void carry_over(const fs::path& old_folder, const fs::path& new_folder) {
  try {
    carry_over_foreign_files(old_folder, new_folder);
  } catch (const fs::filesystem_error& error) {
    fail_to_write(error.path1(), error.code().value());
  }
}

void require_folder_or_nothing(const fs::path& place) {
  if (is_there(place) && !is_folder(place)) fail_to_write(place, ENOTDIR);
}

// Completes the new folder with what is not replaced of the old one.
void prepare(const FolderReplacement& replacement) {
  const auto& [fresh, place, aside] = replacement;
  require_folder_or_nothing(place);
  if (is_folder(place)) {
    carry_over(place, fresh);
    std::error_code ignored;
    fs::permissions(fresh, fs::status(place).permissions(), ignored);
  }
  sync_folder(fresh);
}

}  // namespace

FolderReplacement ResultFolders::replacement(const std::string& name) const {
  return {staging_.fresh() / name, parent_ / name, staging_.old() / name};
}

void ResultFolders::make_folder(const std::string& name) {
  if (made_.contains(name)) return;
  const auto [fresh, place, aside] = replacement(name);
  require_folder_or_nothing(place);
  std::error_code error;
  fs::create_directory(fresh, error);
  if (error) fail_to_write(fresh, error.value());
  made_.insert(name);
}

void ResultFolders::write(const std::string& name, const std::string& file, std::string_view content) {
  const fs::path path = staging_.fresh() / name / file;
  Descriptor opened;
  {
    const auto names = staging_.names();
    make_folder(name);
    opened = create_file(path);
  }
  write_durably(opened, content, path);
}

// What somebody put into an old folder after it was prepared is in the old one only.
void ResultFolders::publish() {
  const auto names = staging_.names();
  std::vector<FolderReplacement> replacements;
  for (const std::string& name : made_) replacements.push_back(replacement(name));
  for (const FolderReplacement& each : replacements) prepare(each);
  std::vector<Replaced> replaced;
  std::error_code error;
  const FolderReplacement* const failed = replace_all(replacements, replaced, error);
  if (failed != nullptr) fail_to_write(failed->place, error.value());
  for (std::size_t i = 0; i < replacements.size(); ++i) {
    if (replaced[i] != Replaced::nothing) carry_over(old_folder(replacements[i], replaced[i]), replacements[i].place);
  }
  sync_folder(parent_);
}

}  // namespace sightline
