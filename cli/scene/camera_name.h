// Camera names become folder names, so they come from input and must not reach outside the output folder.
//
// A name is 1 to 100 bytes of printable characters; it does not begin with '.', '-' or a space, does not end in '.' or
// a space, and has none of / \ : * ? " < > | (not all of them are harmful everywhere, but a folder should travel).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sightline::cli {

// What is wrong with the name; nothing for a good one.
[[nodiscard]] std::optional<std::string> camera_name_defect(std::string_view name);

}  // namespace sightline::cli
