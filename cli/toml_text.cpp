#include "cli/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "geometry/errors.h"

namespace sightline {

namespace {

constexpr std::ptrdiff_t most_dots = 1000;

// The parser recurses into dotted keys, as deep as they go: a.a.a and so on for 10^5 times would be the end of its
// stack. No scene has reason for a line with so many dots, wherever they stand.
void refuse_deep_keys(std::string_view text, const std::string& path) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    if (std::ranges::count(text.substr(0, end), '.') > most_dots)
      throw InputError(path, line, fmt::format("more than {} dots in one line; divide it", most_dots));
    text.remove_prefix(end);
  }
}

bool begins_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '"' || c == '\'';
}

// Goes through a text once, from token to token, as far as quotes, comments and brackets are concerned.
class Scan {
 public:
  Scan(std::string_view text, const std::string& path) : text_(text), path_(path) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  void run() {
    while (at_ < text_.size()) step();
  }

 private:
  void step() {
    const char c = text_[at_];
    const bool is_first = is_first_of_line_;
    if (c != ' ' && c != '\t') is_first_of_line_ = c == '\n' || c == '\r';
    if (c == '#') return pass_comment();
    if (c == '"' || c == '\'') return pass_quotes(c);
    if (static_cast<unsigned char>(c) >= 0x80) fail("a character that is not ASCII stands outside quotes");
    if (c == '[' && is_first && depth_ == 0) return pass_table_bracket();
    if (c == '[' || c == '{') ++depth_;
    if ((c == ']' || c == '}') && depth_ > 0) --depth_;
    ++at_;
  }

  // [name] or [[name]]; what follows the name is passed as if it were a value, with brackets that close nothing.
  void pass_table_bracket() {
    at_ += text_.substr(at_).starts_with("[[") ? 2 : 1;
    at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size());
    if (at_ == text_.size() || !begins_name(text_[at_])) fail("a table's name must follow '['");
  }

  void pass_comment() { at_ = std::min(text_.find_first_of("\r\n", at_), text_.size()); }

  // One quote around text on a line, or three around any; three quotes that close can have up to two more before them.
  void pass_quotes(char quote) {
    const std::string three(3, quote);
    const bool is_long = text_.substr(at_).starts_with(three);
    at_ += is_long ? 3 : 1;
    while (at_ < text_.size() && !text_.substr(at_).starts_with(is_long ? three : three.substr(2))) {
      if (!is_long && (text_[at_] == '\n' || text_[at_] == '\r')) return;
      if (quote == '"' && text_[at_] == '\\') {
        pass_escape();
      } else {
        ++at_;
      }
    }
    at_ = std::min(at_ + (is_long ? 3 : 1), text_.size());
    for (int more = 0; is_long && more < 2 && at_ < text_.size() && text_[at_] == quote; ++more) ++at_;
  }

  // A backslash with the next character; at the end of a line, with all blanks and line ends that follow.
  void pass_escape() {
    constexpr std::string_view blanks = " \t\r\n";
    ++at_;
    if (at_ == text_.size()) return;
    const bool at_blank = blanks.find(text_[at_]) != std::string_view::npos;
    if (at_blank) at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
    if (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) >= 0x80)
      fail("a character that is not ASCII follows a backslash");
    if (!at_blank) ++at_;
  }

  [[noreturn]] void fail(const char* cause) const {
    const auto line = 1 + std::ranges::count(text_.substr(0, at_), '\n');
    throw InputError(path_, static_cast<std::size_t>(line), fmt::format("not valid TOML: {}", cause));
  }

  std::string_view text_;
  const std::string& path_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;  // of brackets and braces in a value
  bool is_first_of_line_ = true;
};

}  // namespace

void check_toml_text(std::string_view text, const std::string& path) {
  refuse_deep_keys(text, path);
  Scan(text, path).run();
}

}  // namespace sightline
