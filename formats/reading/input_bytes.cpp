#include "formats/reading/input_bytes.h"

#include <algorithm>
#include <span>

#include "geometry/numbers/errors.h"

namespace sightline::inline formats {

namespace {

bool is_blank_byte(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool ends_line(char c) { return c == '\n' || c == '\r'; }

}  // namespace

InputBytes::InputBytes(ByteSource source, std::string name)
    : name_(std::move(name)),
      source_(std::move(source)),
      buffer_(2 * longest_token),
      here_(buffer_.data()),
      end_(buffer_.data()) {}

bool InputBytes::refill(std::size_t count) {
  if (!source_) return false;
  const auto size = end_ - here_;
  std::copy(here_, end_, buffer_.data());
  here_ = buffer_.data();
  end_ = here_ + size;
  while (source_ && static_cast<std::size_t>(end_ - here_) < count) {
    const std::size_t added = source_(std::span(buffer_).subspan(static_cast<std::size_t>(end_ - here_)));
    end_ += added;
    if (added == 0) source_ = nullptr;
  }
  return static_cast<std::size_t>(end_ - here_) >= count;
}

bool InputBytes::skip(std::string_view bytes) {
  if (!has(bytes.size()) || !std::equal(bytes.begin(), bytes.end(), here_)) return false;
  advance(bytes.size());
  return true;
}

std::string_view InputBytes::take(std::size_t count) {
  if (!has(count)) fail_at_end();
  const std::string_view taken(here_, count);
  advance(count);
  return taken;
}

void InputBytes::pass_over(std::uint64_t count) {
  while (count > 0) {
    const auto step = static_cast<std::size_t>(std::min<std::uint64_t>(count, longest_token));
    (void)take(step);
    count -= step;
  }
}

bool InputBytes::skip_line_end() {
  if (!has(1) || !ends_line(*here_)) return false;
  const bool is_return = *here_ == '\r';
  const bool two = is_return && line_end_ != LineEnd::lone_return && has(2) && here_[1] == '\n';
  if (line_end_ == LineEnd::unknown) line_end_ = is_return && !two ? LineEnd::lone_return : LineEnd::with_feed;
  advance(two ? 2 : 1);
  ++line_;
  return true;
}

void InputBytes::skip_blanks() {
  while (has(1) && is_blank_byte(*here_)) advance(1);
  if (comment_ == '\0' || !has(1) || *here_ != comment_) return;
  while (has(1) && !ends_line(*here_)) advance(1);
}

std::string_view InputBytes::next_token_of_line() {
  skip_blanks();
  std::size_t size = 0;
  while (has(size + 1) && !is_blank_byte(here_[size]) && !ends_line(here_[size])) {
    if (++size > longest_token)
      fail("a word of more than " + std::to_string(longest_token) + " bytes: " + quoted({here_, size}) +
           "; export the mesh again");
  }
  const std::string_view token(here_, size);
  advance(size);
  return token;
}

std::string_view InputBytes::next_token() {
  std::string_view token = next_token_of_line();
  while (token.empty() && skip_line_end()) token = next_token_of_line();
  return token;
}

void InputBytes::leave_line() {
  while (has(1) && !ends_line(*here_)) advance(1);
  (void)skip_line_end();
}

bool InputBytes::only_blanks_left() {
  do skip_blanks();
  while (skip_line_end());
  return at_end();
}

void InputBytes::fail(const std::string& cause) const {
  if (place_ == Place::byte) throw InputError(name_, 0, "at byte " + std::to_string(offset_) + ": " + cause);
  throw InputError(name_, place_ == Place::line ? line_ : 0, cause);
}

void InputBytes::fail_at_end() const { fail("the file ends before its mesh does; export or copy it again"); }

}  // namespace sightline::inline formats
