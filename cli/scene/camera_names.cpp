#include "cli/scene/camera_names.h"

#include <algorithm>

#include "cli/scene/result_names.h"

namespace sightline::cli {

namespace {

constexpr std::size_t most_name_bytes = 80;  // what is put before and behind has room
constexpr std::string_view no_part_of_names = "/\\:*?\"<>|";

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80; }

// Returns the length of the well-formed UTF-8 character that the text begins with; 0 where none is.
std::size_t character_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), continues_character)) return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool is_overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool is_surrogate = first == 0xED && second >= 0xA0;
  return is_overlong || is_surrogate || (first == 0xF4 && second >= 0x90) ? 0 : length;
}

bool is_printable_character(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (first < 0x20 || first == 0x7F || no_part_of_names.find(character[0]) != std::string_view::npos) return false;
  return !(first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

std::string_view without_folders_and_ending(std::string_view raw) {
  const std::size_t slash = raw.find_last_of("/\\");
  if (slash != std::string_view::npos) raw.remove_prefix(slash + 1);
  const std::size_t dot = raw.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return raw;
  const std::string_view ending = raw.substr(dot + 1);
  const bool is_ending = !ending.empty() && ending.size() <= 5 && std::ranges::all_of(ending, is_ascii) &&
                         std::ranges::any_of(ending, [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; });
  return is_ending ? raw.substr(0, dot) : raw;
}

std::string with_hyphens(std::string_view raw) {
  std::string name;
  while (!raw.empty()) {
    const std::size_t length = character_length(raw);
    const std::string_view character = raw.substr(0, std::max<std::size_t>(length, 1));
    if (name.size() + character.size() > most_name_bytes) break;
    name += length > 0 && is_printable_character(character) ? std::string(character) : "-";
    raw.remove_prefix(character.size());
  }
  return name;
}

}  // namespace

std::string folder_name(std::string_view raw) {
  std::string name = with_hyphens(without_folders_and_ending(raw));
  name.erase(0, std::min(name.find_first_not_of(".- "), name.size()));
  name.erase(name.find_last_not_of(". -") + 1);
  return name.empty() ? "camera" : name;
}

std::string DistinctNames::next(const std::string& name) {
  std::string candidate = name;
  while (is_file_beside_folders(candidate) || !taken_.insert(candidate).second)
    candidate = name + "-" + std::to_string(++repeated_.try_emplace(name, 1).first->second);
  return candidate;
}

}  // namespace sightline::cli
