#include "cli/scene/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

std::size_t line_of(const toml::node& node) { return node.source().begin.line; }

std::string joined(std::initializer_list<std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

}  // namespace

// Of several unknown keys the error names the first one in the file, whatever the order in which the table keeps them.
void TomlReader::allow_only(std::initializer_list<std::string_view> known) const {
  const toml::key* first = nullptr;
  for (const auto& [key, value] : *table_) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    if (first == nullptr || key.source().begin < first->source().begin) first = &key;
  }
  if (first == nullptr) return;
  throw InputError(
      *file_, first->source().begin.line,
      fmt::format("unknown key '{}' in {}; it can have: {}", printable(first->str()), name_, joined(known)));
}

const toml::node& TomlReader::node(std::string_view key) const {
  const toml::node* found = table_->get(key);
  if (found == nullptr) fail(fmt::format("{} has no '{}'; add it", name_, key));
  return *found;
}

std::string TomlReader::text(std::string_view key) const {
  const auto value = node(key).value_exact<std::string>();
  if (!value) fail(key, fmt::format("'{}' must be a text in quotes", key));
  return *value;
}

double TomlReader::number(std::string_view key) const { return finite_number(node(key), key); }

std::optional<double> TomlReader::optional_number(std::string_view key) const {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}

Vector3 TomlReader::vector(std::string_view key) const {
  const auto [x, y, z] = row<3>(node(key), key);
  return {x, y, z};
}

std::vector<Vector3> TomlReader::points(std::string_view key) const {
  const toml::node& value = node(key);
  const toml::array* rows = value.as_array();
  if (rows == nullptr)
    throw InputError(*file_, line_of(value), fmt::format("'{}' must be of the form [[x, y, z], ...]", key));
  std::vector<Vector3> result;
  for (const toml::node& element : *rows) {
    const auto [x, y, z] = row<3>(element, key);
    result.push_back({x, y, z});
  }
  return result;
}

const toml::array& TomlReader::list(std::string_view key, const char* form) const {
  const toml::array* values = node(key).as_array();
  if (values == nullptr) fail(key, fmt::format("'{}' must be of the form {}", key, form));
  return *values;
}

std::vector<std::string> TomlReader::texts(std::string_view key) const {
  std::vector<std::string> result;
  for (const toml::node& element : list(key, "[\"text\", ...]")) {
    const auto value = element.value_exact<std::string>();
    if (!value) throw InputError(*file_, line_of(element), fmt::format("'{}' must be made of texts in quotes", key));
    result.push_back(*value);
  }
  return result;
}

std::vector<double> TomlReader::numbers(std::string_view key) const {
  std::vector<double> result;
  for (const toml::node& element : list(key, "[number, ...]")) result.push_back(finite_number(element, key));
  return result;
}

TomlReader TomlReader::table(std::string_view key) const {
  const toml::node& value = node(key);
  if (!value.is_table()) fail(key, fmt::format("'{}' must be a table: {{ key = value, ... }}", key));
  return {*value.as_table(), *file_, fmt::format("'{}'", key), line_of(value)};
}

std::size_t TomlReader::line(std::string_view key) const { return line_of(node(key)); }

double TomlReader::finite_number(const toml::node& node, std::string_view key) const {
  if (!node.is_number()) throw InputError(*file_, line_of(node), fmt::format("'{}' must be made of numbers", key));
  const double value =
      node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
  if (!std::isfinite(value)) throw InputError(*file_, line_of(node), fmt::format("'{}' must be finite", key));
  return value;
}

const toml::array& TomlReader::array(const toml::node& node, std::string_view key, const char* form,
                                     std::size_t size) const {
  const toml::array* values = node.as_array();
  if (values == nullptr || values->size() != size) {
    throw InputError(*file_, line_of(node),
                     fmt::format("'{}' must be of the form {} with {} entries", key, form, size));
  }
  return *values;
}

void TomlReader::fail(std::string_view key, const std::string& cause) const {
  throw InputError(*file_, has(key) ? line_of(*table_->get(key)) : line_, cause);
}

void TomlReader::fail(const std::string& cause) const { throw InputError(*file_, line_, cause); }

}  // namespace sightline::cli
