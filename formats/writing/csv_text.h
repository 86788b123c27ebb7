// Text in a cell of CSV is quoted, whatever is in it; an empty text stays nothing.
#pragma once

#include <string>
#include <string_view>

namespace sightline::inline formats {

[[nodiscard]] inline std::string csv_text(std::string_view text) {
  if (text.empty()) return "";
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace sightline::inline formats
