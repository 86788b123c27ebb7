// A structured text as a tree: what JSON, YAML and XML have in common, with the line of everything.
//
// In:  a text, and the path that messages name. Out: its root, a table.
// Scalars stay the text that the file has, so that numbers are read in one way, correctly rounded, whatever the format. JSON
// is read by nlohmann-json, YAML by libyaml, XML by expat: all three are strict, keep no state between files, and say where
// an error is. OpenCV's first line, %YAML:1.0, is no YAML to any library; it is passed over.
// Errors: InputError with file and line: what is not well-formed, a table with one key twice, more than `deepest` levels, more
// than `most_nodes` values, YAML's aliases, XML's document types.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/numbers/vector3.h"

namespace sightline::cli {

constexpr std::size_t deepest = 64;
constexpr std::size_t most_nodes = 4000000;

struct DocumentMember;

struct DocumentNode {
  enum class Kind { scalar, list, table };

  Kind kind = Kind::scalar;
  std::string text;                     // of a scalar
  std::vector<DocumentNode> items;      // of a list
  std::vector<DocumentMember> members;  // of a table, in file order
  std::size_t line = 0;

  // Null where there is none.
  [[nodiscard]] const DocumentNode* find(std::string_view key) const;
};

struct DocumentMember {
  std::string key;
  DocumentNode value;
};

[[nodiscard]] DocumentNode parse_json(std::string_view text, const std::string& file);
[[nodiscard]] DocumentNode parse_yaml(std::string_view text, const std::string& file);

// Elements are tables, those of which all are called `_` are lists; attributes say nothing that is asked.
[[nodiscard]] DocumentNode parse_xml(std::string_view text, const std::string& file);

// A finite number. `what` names it in messages.
[[nodiscard]] double number_of(const DocumentNode& node, const std::string& file, std::string_view what);
[[nodiscard]] double parsed_number(std::string_view token, const std::string& file, std::size_t line,
                                   std::string_view what);

// All numbers of a list, of lists in it, or of a text that has them between blanks.
[[nodiscard]] std::vector<double> numbers_of(const DocumentNode& node, const std::string& file, std::string_view what);

}  // namespace sightline::cli
