#include "cli/cameras/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "formats/reading/obj_scanner.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

constexpr std::string_view document_blanks = " \t\r\n\v\f";

void append_numbers(const DocumentNode& node, const std::string& file, std::string_view what,
                    std::vector<double>& numbers) {
  if (node.kind == DocumentNode::Kind::table)
    throw InputError(file, node.line,
                     fmt::format("'{}' must be made of numbers; write a list of them", printable(what)));
  for (const DocumentNode& item : node.items) append_numbers(item, file, what, numbers);
  if (node.kind == DocumentNode::Kind::list) return;
  std::string_view rest = node.text;
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(document_blanks), rest.size()));
    if (rest.empty()) return;
    const std::size_t end = std::min(rest.find_first_of(document_blanks), rest.size());
    numbers.push_back(parsed_number(rest.substr(0, end), file, node.line, what));
    rest.remove_prefix(end);
  }
}

}  // namespace

const DocumentNode* DocumentNode::find(std::string_view key) const {
  const auto found = std::ranges::find_if(members, [key](const DocumentMember& member) { return member.key == key; });
  return found == members.end() ? nullptr : &found->value;
}

double parsed_number(std::string_view token, const std::string& file, std::size_t line, std::string_view what) {
  try {
    return parse_coordinate(token);
  } catch (const std::invalid_argument&) {
    throw InputError(
        file, line,
        fmt::format("'{}' has {}, which is no finite number; write it in digits", printable(what), quoted(token)));
  }
}

double number_of(const DocumentNode& node, const std::string& file, std::string_view what) {
  const std::vector<double> numbers = numbers_of(node, file, what);
  if (numbers.size() != 1)
    throw InputError(file, node.line, fmt::format("'{}' must be one number, not {}", printable(what), numbers.size()));
  return numbers[0];
}

std::vector<double> numbers_of(const DocumentNode& node, const std::string& file, std::string_view what) {
  std::vector<double> numbers;
  append_numbers(node, file, what, numbers);
  return numbers;
}

}  // namespace sightline::cli
