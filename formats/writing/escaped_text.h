// Text within CSV, and within HTML and SVG: what means something there is written so that it does not.
#pragma once

#include <string>
#include <string_view>

namespace sightline::inline formats {

// A cell of CSV: quoted, whatever is in it; nothing for an empty text.
[[nodiscard]] inline std::string csv_text(std::string_view text) {
  if (text.empty()) return "";
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

// Within an element or an attribute.
[[nodiscard]] inline std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace sightline::inline formats
