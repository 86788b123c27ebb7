#include "formats/writing/csv_name.h"

#include <algorithm>
#include <array>

#include "formats/writing/escaped_text.h"

namespace sightline::inline formats {

namespace {

bool is_ascii_digit(char c) { return c >= '0' && c <= '9'; }
bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Months in full and cut, and what stands in times and numbers.
bool is_word_of_dates(std::string_view word) {
  constexpr std::array months{"january", "february", "march",     "april",   "may",      "june",
                              "july",    "august",   "september", "october", "november", "december"};
  std::string small(word);
  std::ranges::transform(small, small.begin(), [](char c) { return static_cast<char>(c | 0x20); });
  if (small == "e" || small == "am" || small == "pm" || small == "t" || small == "z") return true;
  return small.size() >= 3 &&
         std::ranges::any_of(months, [&](std::string_view month) { return month.starts_with(small); });
}

// Whether all its words are those of dates and numbers, and it has a digit and something else.
bool looks_like_date(std::string_view name) {
  bool has_digit = false;
  bool has_other = false;
  for (std::size_t i = 0; i < name.size();) {
    std::size_t end = i;
    while (end < name.size() && is_ascii_letter(name[end])) ++end;
    if (end > i) {
      if (!is_word_of_dates(name.substr(i, end - i))) return false;
      has_other = true;
    } else {
      has_digit = has_digit || is_ascii_digit(name[i]);
      has_other = has_other || !is_ascii_digit(name[i]);
      if (!is_ascii_digit(name[i]) && std::string_view(" -/.:,+").find(name[i]) == std::string_view::npos) return false;
      end = i + 1;
    }
    i = end;
  }
  return has_digit && has_other;
}

bool needs_apostrophe(std::string_view name) {
  return std::string_view("=+-@'\t\r").find(name.front()) != std::string_view::npos || looks_like_date(name);
}

bool needs_quotes(std::string_view cell) {
  return cell.find_first_of(",;\"\r\n") != std::string_view::npos || cell.front() == ' ' || cell.back() == ' ';
}

}  // namespace

std::string csv_name(std::string_view name) {
  if (name.empty()) return "";
  const std::string cell = (needs_apostrophe(name) ? "'" : "") + std::string(name);
  return needs_quotes(cell) ? csv_text(cell) : cell;
}

}  // namespace sightline::inline formats
