// Putting a finished folder where another one may be.
//
// Where the file system can exchange two names (renameat2 with RENAME_EXCHANGE; most on Linux can), `place` is at each
// moment one folder or the other. Where it cannot, or there was nothing at `place`, the fallback is two renames: then a
// crash between the two leaves nothing at `place`, and the old folder at `aside`.
#pragma once

#include <filesystem>
#include <span>
#include <system_error>
#include <vector>

namespace sightline {

struct FolderReplacement {
  std::filesystem::path fresh;  // the finished folder; afterwards, where exchanged, the old one
  std::filesystem::path place;  // where it belongs; a folder, or nothing
  std::filesystem::path aside;  // nothing; afterwards, where moved in two steps, the old one
};

// How a folder came to its place.
enum class Replaced { nothing, at_once, in_two_steps };

// All three paths are on one file system, and the folders of all exist. On an error nothing has changed.
[[nodiscard]] Replaced replace(const FolderReplacement& replacement, std::error_code& error);

// The fallback of replace.
[[nodiscard]] Replaced replace_in_two_steps(const FolderReplacement& replacement, std::error_code& error);

// All of them, one after the other. Where one fails, those before it are undone, and it is returned.
[[nodiscard]] const FolderReplacement* replace_all(std::span<const FolderReplacement> replacements,
                                                   std::vector<Replaced>& replaced, std::error_code& error);

// The opposite of replace, as far as the file system lets.
void undo(const FolderReplacement& replacement, Replaced replaced);

// Where the old folder is afterwards. Precondition: there was one.
[[nodiscard]] const std::filesystem::path& old_folder(const FolderReplacement& replacement, Replaced replaced);

}  // namespace sightline
