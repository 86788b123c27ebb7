// What of a TOML text is refused before the parser sees it.
//
// The parser (toml++ 3.3) takes some things for granted that a hostile text breaks, with undefined behaviour or the end of
// its stack for a result: that a table's name follows its bracket; that a character outside quotes and comments, or after
// a backslash and the blanks behind it, is ASCII; that keys are not deep. TOML 1.0 forbids the first two, but for a line
// that is continued with such a character; no scene has reason for that or for the third. All else is left to the parser: what is only looked at here up to the first place that TOML forbids is right.
//
// Linear in the text. Throws InputError with file and line.
#pragma once

#include <string>
#include <string_view>

namespace sightline {

void check_toml_text(std::string_view text, const std::string& path);

}  // namespace sightline
