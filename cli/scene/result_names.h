// Names in the folder of the results: cameras' names become folder names, so they come from input and must not reach
// outside it; and beside the folders there are files.
//
// A name is 1 to 100 bytes of printable characters; it does not begin with '.', '-' or a space, does not end in '.' or
// a space, and has none of / \ : * ? " < > | (not all of them are harmful everywhere, but a folder should travel).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sightline::cli {

constexpr const char* coverage_file = "coverage.csv";
constexpr const char* regions_file = "regions.csv";
constexpr const char* report_page_file = "report.html";

// Returns what is wrong with the name; nothing for a good one.
[[nodiscard]] std::optional<std::string> name_defect(std::string_view name);

// Also where the file system, or the one that results are copied to, tells no capitals from small letters.
[[nodiscard]] bool is_file_beside_folders(std::string name);

}  // namespace sightline::cli
