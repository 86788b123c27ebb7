#include "formats/reading/obj_scanner.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <stdexcept>

#include "formats/reading/printable.h"

namespace sightline::inline formats {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// std::from_chars takes no leading '+'.
std::string_view without_plus(std::string_view token) { return token.starts_with('+') ? token.substr(1) : token; }

std::string_view without_sign(std::string_view token) {
  return token.starts_with('+') || token.starts_with('-') ? token.substr(1) : token;
}

// Returns the exponent of a decimal number whose digits end at `mantissa_end`, cut to what no file's length can make up
// for.
std::int64_t decimal_exponent(std::string_view number, std::size_t mantissa_end) {
  if (mantissa_end == number.size()) return 0;
  const auto exponent = parse_integer(number.substr(mantissa_end + 1)).value_or(0);
  return std::clamp(exponent, -(std::int64_t{1} << 60), std::int64_t{1} << 60);
}

// Returns, for a number that std::from_chars finds out of range, whether it is too small, not too large.
bool is_below_range(std::string_view number) {
  const std::size_t mantissa_end = std::min(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, mantissa_end);
  const std::size_t first = mantissa.find_first_not_of("0.");
  if (first == std::string_view::npos) return true;
  const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), mantissa.size()));
  return point - static_cast<std::int64_t>(first) + decimal_exponent(number, mantissa_end) < 0;
}

bool looks_not_finite(std::string_view number) {
  const auto starts_with = [&](std::string_view word) {
    return number.size() >= 3 &&
           std::ranges::equal(number.substr(0, 3), word, {}, [](char c) { return static_cast<char>(c | 0x20); });
  };
  return starts_with("nan") || starts_with("inf");
}

}  // namespace

ObjScanner::ObjScanner(ByteSource source)
    : source_(std::move(source)), buffer_(2 * longest_token), here_(buffer_.data()), end_(buffer_.data()) {}

// Moves what is still needed to the front of the buffer: the token that is being read, and what follows.
void ObjScanner::make_room() {
  const char* const needed = token_ != nullptr ? token_ : here_;
  if (static_cast<std::size_t>(here_ - needed) > longest_token) (void)token_until_here();
  const auto before_here = here_ - needed;
  const auto size = end_ - needed;
  std::copy(needed, end_, buffer_.data());
  here_ = buffer_.data() + before_here;
  end_ = buffer_.data() + size;
  if (token_ != nullptr) token_ = buffer_.data();
}

bool ObjScanner::refill(std::size_t count) {
  if (!source_) return false;
  make_room();
  const char* const buffer_end = buffer_.data() + buffer_.size();
  while (source_ && static_cast<std::size_t>(end_ - here_) < count) {
    const auto room = std::span(buffer_).last(static_cast<std::size_t>(buffer_end - end_));
    const std::size_t size = source_(room);
    end_ += size;
    if (size == 0) source_ = nullptr;
  }
  return static_cast<std::size_t>(end_ - here_) >= count;
}

// Returns, after a backslash that ends its line (or the text), its length with the line end, else 0.
std::size_t ObjScanner::continuation_length() {
  if (*here_ != '\\') return 0;
  (void)has(3);
  const auto rest = static_cast<std::size_t>(end_ - here_);
  if (rest == 1) return 1;
  if (here_[1] == '\n') return 2;
  if (here_[1] != '\r') return 0;
  return rest > 2 && here_[2] == '\n' ? 3 : 2;
}

void ObjScanner::skip_blanks() {
  while (has(1)) {
    if (is_blank(*here_)) {
      ++here_;
    } else if (const std::size_t length = continuation_length(); length > 0) {
      here_ += length;
      line_ += length > 1 ? 1 : 0;
    } else {
      return;
    }
  }
}

bool ObjScanner::skip_line_end() {
  if (!has(1) || !is_line_end(*here_)) return false;
  const bool two = *here_ == '\r' && has(2) && here_[1] == '\n';
  here_ += two ? 2 : 1;
  ++line_;
  return true;
}

void ObjScanner::skip_comment() {
  while (has(1) && !is_line_end(*here_)) ++here_;
}

bool ObjScanner::skip(std::string_view bytes) {
  if (!has(bytes.size()) || !std::equal(bytes.begin(), bytes.end(), here_)) return false;
  here_ += bytes.size();
  return true;
}

std::string_view ObjScanner::token_until_here() {
  const std::string_view token(token_, static_cast<std::size_t>(here_ - token_));
  token_ = nullptr;
  if (token.size() > longest_token) {
    throw TokenTooLong("a word of more than " + std::to_string(longest_token) + " bytes: " + quoted(token) +
                       "; export the mesh again");
  }
  return token;
}

std::string_view ObjScanner::next_token() {
  skip_blanks();
  if (has(1) && *here_ == '#') skip_comment();
  token_ = here_;
  while (has(1) && !is_blank(*here_) && !is_line_end(*here_) && continuation_length() == 0) ++here_;
  return token_until_here();
}

std::string_view ObjScanner::next_statement() {
  while (in_statement_ && !next_token().empty()) {
  }
  std::string_view keyword = next_token();
  in_statement_ = true;
  while (keyword.empty() && skip_line_end()) keyword = next_token();
  return keyword;
}

double parse_coordinate(std::string_view token) {
  const std::string_view number = without_sign(token);
  if (looks_not_finite(number)) throw std::invalid_argument("coordinate " + quoted(token) + " is not finite");
  const bool starts_well = !number.empty() && (is_digit(number[0]) || number[0] == '.');
  double value = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (!starts_well || error == std::errc::invalid_argument || stop != number.data() + number.size()) {
    throw std::invalid_argument(quoted(token) + " is not a number");
  }
  if (error == std::errc::result_out_of_range) {
    if (!is_below_range(number))
      throw std::invalid_argument("coordinate " + quoted(token) + " is beyond the range of double");
    value = 0;
  }
  return token.starts_with('-') ? -value : value;
}

std::optional<std::int64_t> parse_integer(std::string_view token) {
  const std::string_view number = without_plus(token);
  if (!token.empty() && number.size() < token.size() && number.starts_with('-')) return std::nullopt;
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error == std::errc::invalid_argument || stop != number.data() + number.size()) return std::nullopt;
  if (error == std::errc{}) return value;
  using Limits = std::numeric_limits<std::int64_t>;
  return number.starts_with('-') ? Limits::min() : Limits::max();
}

std::string quoted(std::string_view token) { return '"' + printable(token) + '"'; }

}  // namespace sightline::inline formats
