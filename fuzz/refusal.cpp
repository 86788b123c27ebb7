#include "fuzz/refusal.h"

#include <algorithm>

namespace sightline::fuzz {
namespace {

bool is_printable_line(std::string_view message) {
  return std::none_of(message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

// A line ends with LF, CR or both.
std::size_t most_lines(std::string_view text) {
  const auto ends = std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; });
  return static_cast<std::size_t>(ends) + 1;
}

}  // namespace

void check_refusal(const InputError& refusal, std::string_view text, const std::string& file) {
  const std::string message = refusal.what();
  if (!is_printable_line(message)) throw Finding("not one printable line: " + message);
  const std::string place = refusal.line() == 0 ? file : file + ":" + std::to_string(refusal.line());
  if (message.rfind(place + ": ", 0) != 0) throw Finding("does not name its place: " + message);
  if (message.size() < place.size() + 10) throw Finding("names no cause: " + message);
  if (refusal.line() > most_lines(text)) throw Finding("names a line past the end: " + message);
}

}  // namespace sightline::fuzz
