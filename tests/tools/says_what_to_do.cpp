#include "tests/tools/says_what_to_do.h"

#include <algorithm>
#include <array>

namespace sightline::tests {

namespace {

// "see" and "use" are of what follows our own words: the command's hint at its help, a weak arithmetic.
constexpr auto remedies = std::to_array<std::string_view>(
    {"add",  "build",  "calibrate", "change", "check",   "choose",    "close",   "copy",   "correct",
     "crop", "direct", "divide",    "draw",   "export",  "give",      "install", "leave",  "list",
     "make", "move",   "name",      "pass",   "project", "raise",     "remove",  "report", "save",
     "say",  "see",    "set",       "take",   "turn",    "undistort", "unpack",  "use",    "write"});

}  // namespace

bool says_what_to_do(std::string_view message) {
  for (const std::string_view accepted : {"must be", "must have", "must not be"}) {
    if (message.find(accepted) != std::string_view::npos) return true;
  }
  const std::size_t end = message.rfind("; ");
  if (end == std::string_view::npos) return false;
  const std::string_view remedy = message.substr(end + 2);
  return std::ranges::find(remedies, remedy.substr(0, remedy.find_first_of(" ,:\n"))) != remedies.end();
}

}  // namespace sightline::tests
