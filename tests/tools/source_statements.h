// The statements of a C++ source, as far as a test has to tell them apart: with their literals, without comments.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sightline::tests {

struct Literal {
  std::size_t place = 0;  // of its first quote in the statement's code
  std::string text;
};

struct Statement {
  std::size_t line = 0;
  std::string code;  // with empty literals
  std::vector<Literal> literals;
};

// No semicolon or brace ends a statement where parentheses are open. Raw literals are left out.
[[nodiscard]] std::vector<Statement> statements_of(const std::string& code);

}  // namespace sightline::tests
