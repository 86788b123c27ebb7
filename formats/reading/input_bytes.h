// The bytes of a file that is text, or numbers in binary, or first one and then the other.
//
// In:  the bytes, in one piece or from a source that hands them out bit by bit; the file's name, for messages.
// Out: tokens, lines and numbers, each good until the next is asked for. Of a source no more is held at once than
//      2 * longest_token. Blanks are space, tab, vertical tab and form feed. A line ends with LF, CR LF or CR; where the
//      first one ends with CR alone, so do all: what follows a CR may then be the first byte of binary data.
// Errors: InputError with the line of the last token, or after begin_binary() with the byte that was reached.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/reading/obj_scanner.h"

namespace sightline::inline formats {

class InputBytes {
 public:
  InputBytes(std::string_view bytes, std::string name)
      : name_(std::move(name)), here_(bytes.data()), end_(bytes.data() + bytes.size()) {}
  InputBytes(ByteSource source, std::string name);
  InputBytes(const InputBytes&) = delete;
  InputBytes& operator=(const InputBytes&) = delete;

  // From here on a token that starts with this character starts a comment, which ends with its line.
  void set_comment(char start) { comment_ = start; }
  // From here on errors name the byte that was reached, or none where no place in the file means anything.
  void begin_binary() { place_ = Place::byte; }
  void name_no_place() { place_ = Place::none; }

  // Returns whether so many bytes follow (at most longest_token).
  [[nodiscard]] bool has(std::size_t count) { return static_cast<std::size_t>(end_ - here_) >= count || refill(count); }
  [[nodiscard]] bool at_end() { return !has(1); }
  // Leaves these bytes behind if they follow.
  bool skip(std::string_view bytes);
  // Returns the next bytes (at most longest_token); it is an error if fewer are left.
  [[nodiscard]] std::string_view take(std::size_t count);
  // Leaves so many bytes behind; it is an error if fewer are left.
  void pass_over(std::uint64_t count);

  // Returns the next token, empty at the end of the file.
  [[nodiscard]] std::string_view next_token();
  // Returns the next token of this line, empty at its end.
  [[nodiscard]] std::string_view next_token_of_line();
  // Goes to the start of the next line.
  void leave_line();
  // Returns whether nothing but blanks, line ends and comments is left; leaves them behind.
  [[nodiscard]] bool only_blanks_left();

  [[nodiscard]] const std::string& name() const { return name_; }
  // Returns the line of the last token, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& cause) const;
  [[noreturn]] void fail_at_end() const;

 private:
  bool refill(std::size_t count);
  void skip_blanks();
  bool skip_line_end();
  void advance(std::size_t count) {
    here_ += count;
    offset_ += count;
  }

  std::string name_;
  ByteSource source_;  // empty: here_ to end_ is all there is
  std::vector<char> buffer_;
  const char* here_;
  const char* end_;
  std::uint64_t offset_ = 0;
  std::size_t line_ = 1;
  char comment_ = '\0';
  enum class Place : std::uint8_t { line, byte, none } place_ = Place::line;
  enum class LineEnd : std::uint8_t { unknown, lone_return, with_feed } line_end_ = LineEnd::unknown;
};

// Returns the number that these bytes are; there are as many as it has.
template <class Unsigned>
[[nodiscard]] Unsigned unsigned_of(std::string_view bytes, std::endian endian) {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    const std::size_t place = endian == std::endian::little ? i : sizeof(Unsigned) - 1 - i;
    value = static_cast<Unsigned>(value | static_cast<Unsigned>(static_cast<unsigned char>(bytes[i])) << (8 * place));
  }
  return value;
}
[[nodiscard]] inline float float_of(std::string_view bytes, std::endian endian) {
  return std::bit_cast<float>(unsigned_of<std::uint32_t>(bytes, endian));
}
[[nodiscard]] inline double double_of(std::string_view bytes, std::endian endian) {
  return std::bit_cast<double>(unsigned_of<std::uint64_t>(bytes, endian));
}

}  // namespace sightline::inline formats
