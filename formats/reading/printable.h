// Bytes of an input file are written here as they can stand in a message: one line, whatever they are.
#pragma once

#include <string>
#include <string_view>

namespace sightline::inline formats {

// Returns the first `most` bytes, and three dots if there are more; what is not printable ASCII as \xNN.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = 40);

}  // namespace sightline::inline formats
