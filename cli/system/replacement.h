// New results take the place of old ones.
//
// Where the file system can exchange two names (renameat2 with RENAME_EXCHANGE; most on Linux can), `place` is at each
// moment one or the other. Where it cannot, or there was nothing at `place`, the fallback is two renames: then a
// crash between the two leaves nothing at `place`, and the old one at `aside`.
#pragma once

#include <filesystem>
#include <span>
#include <system_error>
#include <vector>

namespace sightline::cli {

struct Replacement {
  std::filesystem::path fresh;  // what is finished; afterwards, where exchanged, the old one
  std::filesystem::path place;  // where it belongs; the same kind, or nothing
  std::filesystem::path aside;  // nothing; afterwards, where moved in two steps, the old one
};

// How it came to its place.
enum class Replaced { nothing, at_once, in_two_steps };

// All three paths are on one file system, and the folders they are in exist. On an error nothing has changed.
[[nodiscard]] Replaced replace(const Replacement& replacement, std::error_code& error);

// The fallback of replace.
[[nodiscard]] Replaced replace_in_two_steps(const Replacement& replacement, std::error_code& error);

// All of them, one after the other. Where one fails, those before it are undone, and it is returned.
[[nodiscard]] const Replacement* replace_all(std::span<const Replacement> replacements, std::vector<Replaced>& replaced,
                                             std::error_code& error);

// The opposite of replace, as far as the file system lets.
void undo(const Replacement& replacement, Replaced replaced);

// Where the old one is afterwards. Precondition: there was one.
[[nodiscard]] const std::filesystem::path& old_one(const Replacement& replacement, Replaced replaced);

// A user may have put files into a folder of results whose place new results take. Every entry of the old folder that the
// new one has no entry of the same name for is carried over, so that it is never missing: files as hard links (the
// same file, under both names for a moment), or copies where the file system has no hard links or forbids this one;
// links as links; folders with their permissions and all that is in them.
// Errors: std::filesystem::filesystem_error, and then the old folder is as it was.
void carry_over_foreign_files(const std::filesystem::path& old_folder, const std::filesystem::path& new_folder);

}  // namespace sightline::cli
