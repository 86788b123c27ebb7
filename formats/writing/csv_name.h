// A name as a cell of CSV, safe also where a spreadsheet opens it.
//
// In:  one line of text, from a file that nobody has looked at.
// Out: the name; in quotation marks where commas, quotation marks or blanks at its ends ask for it (RFC 4180). A name that a
//      spreadsheet would take for a formula (it begins with = + - @) or for a date or number other than an integer (3-7, 1/2, MAR1,
//      1e5) has an apostrophe before it; so has one that begins with an apostrophe. So one apostrophe at the front of a cell
//      is never a part of the name.
#pragma once

#include <string>
#include <string_view>

namespace sightline::inline formats {

[[nodiscard]] std::string csv_name(std::string_view name);

}  // namespace sightline::inline formats
