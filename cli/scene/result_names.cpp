#include "cli/scene/result_names.h"

namespace sightline::cli {

namespace {

constexpr std::size_t longest_name = 100;

// In UTF-8: U+0000 to U+001F, U+007F, and U+0080 to U+009F, which are C2 80 to C2 9F.
bool has_control_character(std::string_view name) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = static_cast<unsigned char>(name[i]);
    if (byte < 0x20 || byte == 0x7F) return true;
    if (byte == 0xC2 && i + 1 < name.size() && static_cast<unsigned char>(name[i + 1]) < 0xA0) return true;
  }
  return false;
}

bool begins_with_one_of(std::string_view name, std::string_view set) { return set.find(name.front()) != set.npos; }
bool ends_with_one_of(std::string_view name, std::string_view set) { return set.find(name.back()) != set.npos; }

}  // namespace

std::optional<std::string> name_defect(std::string_view name) {
  if (name.empty()) return "is empty";
  if (name.size() > longest_name) return "is longer than " + std::to_string(longest_name) + " bytes";
  if (has_control_character(name)) return "has a control character";
  if (name.find_first_of("/\\:*?\"<>|") != name.npos) return "has one of / \\ : * ? \" < > |";
  if (begins_with_one_of(name, ".- ")) return "begins with a dot, a hyphen or a space";
  if (ends_with_one_of(name, ". ")) return "ends in a dot or a space";
  return std::nullopt;
}

bool is_file_beside_folders(std::string name) {
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name == coverage_file || name == regions_file || name == report_page_file;
}

}  // namespace sightline::cli
