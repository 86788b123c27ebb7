// The lexical layer of OBJ: statements, tokens, numbers.
//
// In:  the text of a file, in one piece.
// Out: views into it; nothing is copied. A line ends with LF, CR LF or CR. A statement is a line; a backslash at the
//      end of a line continues it, and separates tokens like a blank. A token that starts with '#' starts a comment,
//      which ends with its line (a backslash does not continue a comment). Blanks are space, tab, vertical tab and
//      form feed. All other bytes, NUL too, are part of tokens.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sightline {

class ObjScanner {
 public:
  explicit ObjScanner(std::string_view text) : here_(text.data()), end_(text.data() + text.size()) {}

  // Leaves the rest of this statement; returns the first token of the next one that is not empty, empty at the end.
  std::string_view next_statement();

  // The next token of this statement, empty at its end.
  std::string_view next_token();

  // The line of the last token, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  bool skip_line_end();
  void skip_blanks();
  [[nodiscard]] std::size_t continuation_length() const;

  const char* here_;
  const char* end_;
  std::size_t line_ = 1;
  bool in_statement_ = false;
};

// The double nearest to a decimal number (ties to even): digits with an optional point, optional sign and exponent.
// Below the range of double this is a denormal or a zero with the number's sign. Throws std::invalid_argument, with the
// cause, if it is no number, not finite, or beyond the range of double.
[[nodiscard]] double parse_coordinate(std::string_view token);

// An integer with an optional sign; nullopt if it is none. What does not fit 64 bits becomes the nearest that does.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view token);

// The token for use in a message: in quotes, unprintable bytes as \xHH, cut after 40 bytes.
[[nodiscard]] std::string quoted(std::string_view token);

}  // namespace sightline
