#include "cli/system/replacement.h"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>

namespace sightline::cli {

namespace {

namespace fs = std::filesystem;

std::error_code exchange(const fs::path& a, const fs::path& b) {
  if (renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0) return {};
  return {errno, std::generic_category()};
}

bool cannot_exchange(const std::error_code& error) {
  return error == std::errc::invalid_argument || error == std::errc::function_not_supported ||
         error == std::errc::operation_not_supported;
}

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

Replaced replace(const Replacement& replacement, std::error_code& error) {
  error = exchange(replacement.fresh, replacement.place);
  if (!error) return Replaced::at_once;
  if (error != std::errc::no_such_file_or_directory && !cannot_exchange(error)) return Replaced::nothing;
  return replace_in_two_steps(replacement, error);
}

Replaced replace_in_two_steps(const Replacement& replacement, std::error_code& error) {
  fs::rename(replacement.place, replacement.aside, error);
  const bool was_there = !error;
  if (error && error != std::errc::no_such_file_or_directory) return Replaced::nothing;
  fs::rename(replacement.fresh, replacement.place, error);
  if (!error) return was_there ? Replaced::in_two_steps : Replaced::nothing;
  std::error_code ignored;
  if (was_there) fs::rename(replacement.aside, replacement.place, ignored);
  return Replaced::nothing;
}

const Replacement* replace_all(std::span<const Replacement> replacements, std::vector<Replaced>& replaced,
                               std::error_code& error) {
  for (const Replacement& replacement : replacements) {
    const Replaced how = replace(replacement, error);
    if (error) {
      for (; !replaced.empty(); replaced.pop_back()) undo(replacements[replaced.size() - 1], replaced.back());
      return &replacement;
    }
    replaced.push_back(how);
  }
  return nullptr;
}

void undo(const Replacement& replacement, Replaced replaced) {
  std::error_code ignored;
  if (replaced == Replaced::at_once) {
    (void)exchange(replacement.fresh, replacement.place);
    return;
  }
  fs::rename(replacement.place, replacement.fresh, ignored);
  if (replaced == Replaced::in_two_steps) fs::rename(replacement.aside, replacement.place, ignored);
}

const fs::path& old_one(const Replacement& replacement, Replaced replaced) {
  return replaced == Replaced::at_once ? replacement.fresh : replacement.aside;
}

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
