#include "cli/system/foreign_files.h"

namespace sightline::cli {

namespace {

namespace fs = std::filesystem;

void carry_over_file(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_hard_link(from, to, error);
  if (error) fs::copy(from, to, fs::copy_options::copy_symlinks);
}

// A file of the results does not replace a folder with all that is in it.
void carry_over_folder(const fs::path& from, const fs::path& to, bool is_there) {
  if (!is_there) fs::create_directory(to, from);
  carry_over_foreign_files(from, to);
}

}  // namespace

void carry_over_foreign_files(const fs::path& old_folder, const fs::path& new_folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(old_folder)) {
    const fs::path to = new_folder / entry.path().filename();
    const bool is_folder = fs::is_directory(entry.symlink_status());
    const bool is_replaced = fs::exists(fs::symlink_status(to));
    if (is_folder) {
      carry_over_folder(entry.path(), to, is_replaced);
    } else if (!is_replaced) {
      carry_over_file(entry.path(), to);
    }
  }
}

}  // namespace sightline::cli
