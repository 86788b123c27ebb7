#include "cli/system/result_folders.h"

#include <cerrno>

namespace sightline::cli {

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

void require_file_or_nothing(const fs::path& place) {
  std::error_code ignored;
  if (is_folder(place)) fail_to_write(place, EISDIR);
  if (is_there(place) && !fs::is_regular_file(fs::symlink_status(place, ignored))) fail_to_write(place, EEXIST);
}

void hand_on_permissions(const fs::path& old_one, const fs::path& new_one) {
  std::error_code ignored;
  if (is_there(old_one)) fs::permissions(new_one, fs::status(old_one).permissions(), ignored);
}

// Completes the new folder with what is not replaced of the old one.
void prepare_folder(const Replacement& replacement) {
  const auto& [fresh, place, aside] = replacement;
  require_folder_or_nothing(place);
  if (is_folder(place)) carry_over(place, fresh);
  hand_on_permissions(place, fresh);
  sync_folder(fresh);
}

void prepare_file(const Replacement& replacement) {
  require_file_or_nothing(replacement.place);
  hand_on_permissions(replacement.place, replacement.fresh);
}

}  // namespace

Replacement ResultFolders::replacement(const std::string& name) const {
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
  write(name, file, [&](TextBuffer& out) { out << content; });
}

void ResultFolders::write(const std::string& name, const std::string& file,
                          const std::function<void(TextBuffer&)>& write_text) {
  const fs::path path = staging_.fresh() / name / file;
  Descriptor opened;
  {
    const auto names = staging_.names();
    make_folder(name);
    opened = create_file(path);
  }
  TextBuffer out([&](std::string_view piece) { write_all(opened, piece, path); });
  write_text(out);
  out.flush();
  sync_file(opened, path);
}

void ResultFolders::write_beside(const std::string& file, std::string_view content) {
  const fs::path path = staging_.fresh() / file;
  Descriptor opened;
  {
    const auto names = staging_.names();
    require_place_beside(file);
    opened = create_file(path);
    files_.insert(file);
  }
  write_all(opened, content, path);
  sync_file(opened, path);
}

void ResultFolders::require_place_beside(const std::string& file) const { require_file_or_nothing(parent_ / file); }

// The folders first.
std::vector<Replacement> ResultFolders::prepared() const {
  std::vector<Replacement> replacements;
  for (const std::string& name : made_) prepare_folder(replacements.emplace_back(replacement(name)));
  for (const std::string& file : files_) prepare_file(replacements.emplace_back(replacement(file)));
  return replacements;
}

// What somebody put into an old folder after it was prepared is in the old one only.
void ResultFolders::publish() {
  const auto names = staging_.names();
  const std::vector<Replacement> replacements = prepared();
  std::vector<Replaced> replaced;
  std::error_code error;
  const Replacement* const failed = replace_all(replacements, replaced, error);
  if (failed != nullptr) fail_to_write(failed->place, error.value());
  for (std::size_t i = 0; i < made_.size(); ++i) {
    if (replaced[i] != Replaced::nothing) carry_over(old_one(replacements[i], replaced[i]), replacements[i].place);
  }
  sync_folder(parent_);
}

}  // namespace sightline::cli
