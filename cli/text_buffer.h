// A growing text: numbers are appended without locale, allocation or format strings, because writing must not take
// longer than computing.
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace sightline {

class TextBuffer {
 public:
  // expected: so many characters are written about. A guess that is too low costs time, one that is too high nothing but
  // addresses.
  explicit TextBuffer(std::size_t expected = 0) { text_.reserve(expected); }

  TextBuffer& operator<<(std::string_view text) {
    text_.append(text);
    return *this;
  }
  TextBuffer& operator<<(char c) {
    text_.push_back(c);
    return *this;
  }
  TextBuffer& operator<<(std::uint64_t value) { return append(value); }
  TextBuffer& operator<<(std::uint32_t value) { return append(value); }
  // The shortest text that reads back as the same double: at most 17 significant digits.
  TextBuffer& operator<<(double value) { return append(value); }

  [[nodiscard]] std::size_t size() const { return text_.size(); }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  template <class Number>
  TextBuffer& append(Number value) {
    std::array<char, 32> digits;
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text_.append(digits.data(), result.ptr);
    return *this;
  }

  std::string text_;
};

}  // namespace sightline
