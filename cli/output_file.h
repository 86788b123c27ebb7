// One file that appears at once: the old one stays until the new one is on the disk.
//
// Holds: a file at `path` is replaced in one step; what was begun is removed after an error.
// Errors: OutputError.
#pragma once

#include <string>
#include <string_view>

namespace sightline {

void write_output_file(const std::string& path, std::string_view content);

}  // namespace sightline
