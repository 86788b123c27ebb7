// A text line by line, and a line word by word.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace sightline::cli {

// Lines end with LF, or CR and LF; both are no part of a line. The byte order mark is no part of the first.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  // Nothing after the last one.
  [[nodiscard]] std::optional<std::string_view> next();

  // The number of the line that next() gave last, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

// Takes the first word off the line; nothing where only blanks are left.
[[nodiscard]] std::string_view take_word(std::string_view& line);

[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);
[[nodiscard]] std::string_view without_blanks_around(std::string_view text);

}  // namespace sightline::cli
