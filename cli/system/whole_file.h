// A file's text, all of it.
#pragma once

#include <string>

namespace sightline::cli {

// No text of settings has more bytes.
constexpr std::size_t longest_text_file = std::size_t{64} << 20;

// what: "the scene file", for messages. Errors: InputError: a file that cannot be read, one with more bytes.
[[nodiscard]] std::string whole_file(const std::string& path, const std::string& what);

}  // namespace sightline::cli
