// The lexical layer of OBJ: statements, tokens, numbers.
//
// In:  the text, in one piece or from a source that hands it out bit by bit.
// Out: tokens, each good until the next one is asked for. Of a source no more is held at once than 2 * longest_token,
//      however long its lines are. A line ends with LF, CR LF or CR. A statement is a line; a backslash at the
//      end of a line continues it, and separates tokens like a blank. A token that starts with '#' starts a comment,
//      which ends with its line (a backslash does not continue a comment). Blanks are space, tab, vertical tab and
//      form feed. All other bytes, NUL too, are part of tokens.
// Errors: TokenTooLong, and what the source throws.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::inline formats {

// A source fills the span from its front and returns how many bytes it has put there; 0 at the end of the text.
using ByteSource = std::function<std::size_t(std::span<char>)>;

// A token of more than this many bytes is an error.
constexpr std::size_t longest_token = std::size_t{1} << 20;

class TokenTooLong : public std::length_error {
  using std::length_error::length_error;
};

class ObjScanner {
 public:
  explicit ObjScanner(std::string_view text) : here_(text.data()), end_(text.data() + text.size()) {}
  explicit ObjScanner(ByteSource source);
  ObjScanner(const ObjScanner&) = delete;
  ObjScanner& operator=(const ObjScanner&) = delete;

  // Returns whether the text goes on with these bytes (at most three); if so, leaves them behind.
  bool skip(std::string_view bytes);

  // Leaves the rest of this statement; returns the first token of the next one that is not empty, empty at the end.
  std::string_view next_statement();

  // Returns the next token of this statement, empty at its end.
  std::string_view next_token();

  // Returns the line of the last token, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  // Returns whether the text has so many bytes from here on; if so, they are in one piece at here_.
  bool has(std::size_t count) { return static_cast<std::size_t>(end_ - here_) >= count || refill(count); }
  bool refill(std::size_t count);
  void make_room();
  bool skip_line_end();
  void skip_blanks();
  void skip_comment();
  std::string_view token_until_here();
  [[nodiscard]] std::size_t continuation_length();

  ByteSource source_;  // empty: here_ to end_ is all there is
  std::vector<char> buffer_;
  const char* token_ = nullptr;  // the start of the token that is being read
  const char* here_;
  const char* end_;
  std::size_t line_ = 1;
  bool in_statement_ = false;
};

// Returns the double nearest to a decimal number (ties to even), which is digits with an optional point, optional sign
// and exponent. Below the range of double this is a denormal or a zero with the number's sign. Throws
// std::invalid_argument, with the cause, if it is no number, not finite, or beyond the range of double.
[[nodiscard]] double parse_coordinate(std::string_view token);

// Returns an integer with an optional sign; nullopt if it is none. What does not fit 64 bits becomes the nearest that
// does.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view token);

// Returns the token for use in a message: in quotes, unprintable bytes as \xHH, cut after 40 bytes.
[[nodiscard]] std::string quoted(std::string_view token);

}  // namespace sightline::inline formats
