#include "cli/system/replacement.h"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>

namespace sightline::cli {

namespace {

std::error_code exchange(const std::filesystem::path& a, const std::filesystem::path& b) {
  if (renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0) return {};
  return {errno, std::generic_category()};
}

bool cannot_exchange(const std::error_code& error) {
  return error == std::errc::invalid_argument || error == std::errc::function_not_supported ||
         error == std::errc::operation_not_supported;
}

}  // namespace

Replaced replace(const Replacement& replacement, std::error_code& error) {
  error = exchange(replacement.fresh, replacement.place);
  if (!error) return Replaced::at_once;
  if (error != std::errc::no_such_file_or_directory && !cannot_exchange(error)) return Replaced::nothing;
  return replace_in_two_steps(replacement, error);
}

Replaced replace_in_two_steps(const Replacement& replacement, std::error_code& error) {
  std::filesystem::rename(replacement.place, replacement.aside, error);
  const bool was_there = !error;
  if (error && error != std::errc::no_such_file_or_directory) return Replaced::nothing;
  std::filesystem::rename(replacement.fresh, replacement.place, error);
  if (!error) return was_there ? Replaced::in_two_steps : Replaced::nothing;
  std::error_code ignored;
  if (was_there) std::filesystem::rename(replacement.aside, replacement.place, ignored);
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
  std::filesystem::rename(replacement.place, replacement.fresh, ignored);
  if (replaced == Replaced::in_two_steps) std::filesystem::rename(replacement.aside, replacement.place, ignored);
}

const std::filesystem::path& old_one(const Replacement& replacement, Replaced replaced) {
  return replaced == Replaced::at_once ? replacement.fresh : replacement.aside;
}

}  // namespace sightline::cli
