// Reading a TOML table key by key, with the file and the line in every complaint.
//
// In:  a table and the keys it may have. Out: their values, checked for type, size and finiteness.
// Errors: InputError with file, line and key: an unknown key, a missing one, a wrong type, a wrong length.
#pragma once

// toml++ 3.3 asserts, and in release builds tells clang++ to assume, what some hostile texts break. Without that it
// reports an error for them, as it does with g++.
#include <toml++/impl/preprocessor.h>
#undef TOML_ASSERT
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT(expr) static_assert(true)
#define TOML_ASSERT_ASSUME(expr) static_assert(true)
#include <toml++/toml.h>

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vector3.h"

namespace sightline {

class TomlReader {
 public:
  // name: how messages call the table, e.g. "[mesh]". table and file outlive the reader. line: where the table begins.
  TomlReader(const toml::table& table, const std::string& file, std::string name, std::size_t line)
      : table_(&table), file_(&file), name_(std::move(name)), line_(line) {}

  // Throws if the table has a key that is not in `known`.
  void allow_only(std::initializer_list<std::string_view> known) const;

  [[nodiscard]] bool has(std::string_view key) const { return table_->get(key) != nullptr; }
  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key) const;
  [[nodiscard]] std::optional<double> optional_number(std::string_view key) const;
  [[nodiscard]] Vector3 vector(std::string_view key) const;
  [[nodiscard]] std::array<double, 2> pair(std::string_view key) const { return row<2>(node(key), key); }

  // [[x, y, z], ...], however many.
  [[nodiscard]] std::vector<Vector3> points(std::string_view key) const;

  template <std::size_t Columns>
  [[nodiscard]] std::array<std::array<double, Columns>, 3> matrix(std::string_view key) const {
    const toml::array& rows = array(node(key), key, "[[...], [...], [...]]", 3);
    std::array<std::array<double, Columns>, 3> result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = row<Columns>(*rows.get(i), key);
    return result;
  }

  // The complaint about the key, or about the table where there is no such key.
  [[noreturn]] void fail(std::string_view key, const std::string& cause) const;
  [[noreturn]] void fail(const std::string& cause) const;

 private:
  [[nodiscard]] const toml::node& node(std::string_view key) const;
  [[nodiscard]] const toml::array& array(const toml::node& node, std::string_view key, const char* form,
                                         std::size_t size) const;
  [[nodiscard]] double finite_number(const toml::node& node, std::string_view key) const;

  template <std::size_t Size>
  [[nodiscard]] std::array<double, Size> row(const toml::node& node, std::string_view key) const {
    const toml::array& values = array(node, key, "[number, ...]", Size);
    std::array<double, Size> result;
    for (std::size_t i = 0; i < Size; ++i) result[i] = finite_number(*values.get(i), key);
    return result;
  }

  const toml::table* table_;
  const std::string* file_;
  std::string name_;
  std::size_t line_;
};

}  // namespace sightline
