#include "tests/tools/source_statements.h"

#include <algorithm>
#include <cctype>

namespace sightline::tests {

namespace {

// Reads one statement after the other.
class StatementScanner {
 public:
  explicit StatementScanner(std::string text) : text_(std::move(text)) {}

  std::vector<Statement> run() {
    while (here_ < text_.size()) {
      if (text_.compare(here_, 2, "//") == 0) {
        here_ = std::min(text_.find('\n', here_), text_.size());
      } else if (text_.compare(here_, 3, "R\"(") == 0) {
        skip_raw_literal();
      } else if (text_[here_] == '"') {
        read_literal();
      } else {
        read_code();
      }
    }
    return std::move(statements_);
  }

 private:
  void skip_raw_literal() {
    const std::size_t end = text_.find(")\"", here_) + 2;
    line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(here_),
                                                 text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    here_ = end;
  }

  // Literals with nothing between them are one.
  void read_literal() {
    const bool goes_on = !now_.code.empty() && now_.code.ends_with("\"\"");
    if (!goes_on) {
      now_.literals.push_back({now_.code.size(), ""});
      now_.code += "\"\"";
    }
    while (text_[++here_] != '"') {
      if (text_[here_] == '\\') ++here_;
      now_.literals.back().text += text_[here_];
    }
    ++here_;
  }

  // Not within a number, 1'000.
  [[nodiscard]] bool is_word_before(std::size_t place) const {
    return place > 0 && std::isalnum(static_cast<unsigned char>(text_[place - 1])) != 0;
  }
  void skip_character() { here_ = text_.find('\'', here_ + (text_[here_] == '\\' ? 2 : 1)) + 1; }

  void read_code() {
    const char c = text_[here_++];
    if (c == '\n') ++line_;
    if (c == '\'' && !is_word_before(here_ - 1)) skip_character();
    depth_ += (c == '(' ? 1 : 0) - (c == ')' ? 1 : 0);
    if (depth_ <= 0 && (c == ';' || c == '{' || c == '}')) {
      statements_.push_back(std::move(now_));
      now_ = {};
      depth_ = 0;
    } else if (c != ' ' && c != '\n') {
      if (now_.code.empty()) now_.line = line_;
      now_.code += c;
    } else if (!now_.code.empty() && now_.code.back() != ' ' && !now_.code.ends_with("\"\"")) {
      now_.code += ' ';
    }
  }

  std::string text_;
  std::size_t here_ = 0;
  std::size_t line_ = 1;
  int depth_ = 0;
  Statement now_;
  std::vector<Statement> statements_;
};

}  // namespace

std::vector<Statement> statements_of(const std::string& code) { return StatementScanner(code).run(); }

}  // namespace sightline::tests
