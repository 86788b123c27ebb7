// In text for HTML and SVG, what means something there is written so that it does not.
#pragma once

#include <string>
#include <string_view>

namespace sightline::inline formats {

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
