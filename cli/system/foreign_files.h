// What a user put into a folder of results, when new results take the folder's place.
//
// Every entry of the old folder that the new one has no entry of the same name for is carried over, so that it is never
// missing: files as hard links (the same file, under both names for a moment), or copies where the file system has no
// hard links or forbids this one; links as links; folders with their permissions and all that is in them.
// Errors: std::filesystem::filesystem_error, and then the old folder is as it was.
#pragma once

#include <filesystem>

namespace sightline::cli {

void carry_over_foreign_files(const std::filesystem::path& old_folder, const std::filesystem::path& new_folder);

}  // namespace sightline::cli
