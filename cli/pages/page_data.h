// Data for a page: compressed with gzip, in base64.
//
// Holds: the same bytes give the same text with one version of zlib; the text is of A-Z a-z 0-9 + / = only.
// Errors: std::bad_alloc.
#pragma once

#include <string>
#include <string_view>

namespace sightline::cli {

[[nodiscard]] std::string packed(std::string_view bytes);

// The parts of it.
[[nodiscard]] std::string gzip(std::string_view bytes);
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace sightline::cli
