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
  throw InputError(*file_, first->source().begin.line,
                   fmt::format("unknown key '{}' in {}; it can have: {}; correct or remove it", printable(first->str()),
                               name_, joined(known)));
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

std::vector<double> TomlReader::numbers(std::string_view key) const {
  const toml::node& value = node(key);
  const toml::array* entries = value.as_array();
  if (entries == nullptr)
    throw InputError(*file_, line_of(value), fmt::format("'{}' must be of the form [number, ...]", key));
  std::vector<double> result;
  for (const toml::node& entry : *entries) result.push_back(finite_number(entry, key));
  return result;
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

std::vector<std::vector<double>> TomlReader::rows(std::string_view key) const {
  const toml::node& value = node(key);
  const toml::array* elements = value.as_array();
  std::vector<std::vector<double>> result;
  for (std::size_t i = 0; elements != nullptr && i < elements->size(); ++i) {
    const toml::array* row = elements->get(i)->as_array();
    result.emplace_back();
    if (row == nullptr) elements = nullptr;
    for (std::size_t j = 0; row != nullptr && j < row->size(); ++j)
      result.back().push_back(finite_number(*row->get(j), key));
  }
  if (elements == nullptr) fail(key, fmt::format("'{}' must be of the form [[number, ...], ...]", key));
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

std::size_t TomlReader::count_of(const toml::node& node, std::string_view key, std::size_t most) const {
  const auto value = node.value_exact<std::int64_t>();
  if (!value || *value < 1 || static_cast<std::uint64_t>(*value) > most)
    throw InputError(*file_, line_of(node), fmt::format("'{}' must be a whole number from 1 to {}", key, most));
  return static_cast<std::size_t>(*value);
}

std::size_t TomlReader::count(std::string_view key, std::size_t most) const { return count_of(node(key), key, most); }

std::vector<std::size_t> TomlReader::counts(std::string_view key, std::size_t most) const {
  std::vector<std::size_t> result;
  for (const toml::node& element : list(key, "[number, ...]")) result.push_back(count_of(element, key, most));
  return result;
}

TomlReader TomlReader::table(std::string_view key) const {
  const toml::node& value = node(key);
  if (!value.is_table()) fail(key, fmt::format("'{}' must be a table: {} = {{ ... }}", key, key));
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
