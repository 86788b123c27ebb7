// A text that grows: numbers are appended without locale, allocation or format strings, because writing must not take
// longer than computing.
//
// In:  where the text goes: nowhere (take() has all of it), or to a sink, in portions, so that a large one is never in
//      memory as a whole and each portion is written while it is in the processor's cache.
#pragma once

#include <charconv>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace sightline::inline formats {

class TextBuffer {
 public:
  using Sink = std::function<void(std::string_view)>;

  explicit TextBuffer(Sink sink = {}) : sink_(std::move(sink)), text_(piece_length + longest_number, '\0') {}

  TextBuffer& operator<<(std::string_view text) {
    make_room(text.size());
    length_ += text.copy(end(), text.size());
    return *this;
  }
  TextBuffer& operator<<(char c) {
    make_room(1);
    text_[length_++] = c;
    return *this;
  }
  TextBuffer& operator<<(std::uint64_t value) { return append(value); }
  TextBuffer& operator<<(std::uint32_t value) { return append(value); }
  // Appends the shortest text that reads back as the same double: at most 17 significant digits.
  TextBuffer& operator<<(double value) { return append(value); }

  // Hands on what the sink has not got yet. This is called at the end: a sink may throw.
  void flush() {
    if (!sink_) return;
    sink_(std::string_view(text_.data(), length_));
    length_ = 0;
  }

  // Returns the size so far, of a text that goes to no sink.
  [[nodiscard]] std::size_t size() const { return length_; }
  [[nodiscard]] std::string take() {
    text_.resize(length_);
    return std::move(text_);
  }

 private:
  static constexpr std::size_t piece_length = std::size_t{1} << 16;
  static constexpr std::size_t longest_number = 32;

  template <class Number>
  TextBuffer& append(Number value) {
    make_room(longest_number);
    length_ = static_cast<std::size_t>(std::to_chars(end(), end() + longest_number, value).ptr - text_.data());
    return *this;
  }

  [[nodiscard]] char* end() { return text_.data() + length_; }

  void make_room(std::size_t length) {
    if (text_.size() - length_ >= length) return;
    flush();
    if (text_.size() - length_ < length) text_.resize(2 * text_.size() + length);
  }

  Sink sink_;
  std::string text_;  // as long as there is room
  std::size_t length_ = 0;
};

// Returns what `write` appends.
template <class Write>
[[nodiscard]] std::string text_of(const Write& write) {
  TextBuffer out;
  write(out);
  return out.take();
}

}  // namespace sightline::inline formats
