// A file whose parts are read in any order is held as a whole.
#pragma once

#include <filesystem>
#include <string>

#include "formats/reading/read_limits.h"

namespace sightline::inline formats {

// Errors: InputError if it cannot be read, or has more bytes than the limit on memory.
[[nodiscard]] std::string whole_file(const std::filesystem::path& file, const ReadLimits& limits);

}  // namespace sightline::inline formats
