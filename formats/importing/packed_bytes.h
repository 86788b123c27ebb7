// Bytes that are packed in text (base64) or in an archive (ZIP).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace sightline::inline formats {

// Returns what base64 stands for; nothing if it is none. Padding may be missing.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

// Hands the bytes of one file of a ZIP archive on, portion by portion, until `take` returns false or all is taken.
//
// Files that are stored or deflated are read, as the central directory at the archive's end says.
// Errors: std::runtime_error with the cause: no archive, no such file, another method of compression, a password, ZIP64,
//         bytes that are damaged (their checksum is compared).
// Memory: O(1), whatever the file unpacks to.
void unpack(std::string_view archive, std::string_view file, const std::function<bool(std::string_view)>& take);

}  // namespace sightline::inline formats
