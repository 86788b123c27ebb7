// A text in pieces of any size gives the tokens and lines that it gives in one piece.
#include "formats/reading/obj_scanner.h"

#include <doctest/doctest.h>

#include <random>

#include "tests/tools/command_runner.h"
#include "tests/tools/obj_case.h"

namespace sightline::tests::obj_scanner_test {
namespace {

struct Token {
  std::string text;
  std::size_t line;
  bool starts_statement;
  bool operator==(const Token&) const = default;
};

std::vector<Token> all_tokens(ObjScanner& scanner) {
  std::vector<Token> tokens;
  for (auto keyword = scanner.next_statement(); !keyword.empty(); keyword = scanner.next_statement()) {
    tokens.push_back({std::string(keyword), scanner.line(), true});
    for (auto token = scanner.next_token(); !token.empty(); token = scanner.next_token()) {
      tokens.push_back({std::string(token), scanner.line(), false});
    }
  }
  tokens.push_back({"", scanner.line(), true});
  return tokens;
}

ByteSource in_pieces(std::string_view text, std::size_t piece) {
  return [text, piece](std::span<char> to) mutable {
    const std::size_t size = std::min({piece, text.size(), to.size()});
    std::copy_n(text.begin(), size, to.begin());
    text.remove_prefix(size);
    return size;
  };
}

void check_pieces(const std::string& text) {
  ObjScanner whole(text);
  const std::vector<Token> expected = all_tokens(whole);
  for (const std::size_t piece : {1U, 2U, 3U, 7U, 1U << 20U}) {
    INFO("pieces of " << piece);
    ObjScanner scanner(in_pieces(text, piece));
    const bool same = all_tokens(scanner) == expected;
    CHECK(same);
  }
}

TEST_CASE("every malformed file in pieces") {
  const std::filesystem::path folder = std::filesystem::path(SIGHTLINE_FIXTURES_DIR) / "bad-obj";
  for (const std::string& file : tests::files_in(folder)) {
    INFO(file);
    check_pieces(tests::read_text(folder / file));
  }
}

TEST_CASE("random texts of what the scanner looks at, in pieces") {
  const unsigned seed = std::random_device{}();
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const std::string letters = "\\\\\\\r\r\n\n# \tav1";
  std::size_t continued = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (std::size_t size = random() % 40; text.size() < size;) text += letters[random() % letters.size()];
    continued += text.find("\\\r\n") != std::string::npos ? 1 : 0;
    check_pieces(text);
  }
  CHECK(continued > 100);
}

TEST_CASE("a token as long as allowed is read, a longer one is not, from a text and from a source") {
  const std::string longest(longest_token, '7');
  const std::string too_long(longest_token + 1, '7');
  const std::string good_line = "v " + longest + " 1";
  const std::string bad_line = "v " + too_long + " 1";
  for (const std::size_t piece : {std::size_t{4096}, std::size_t{1} << 30}) {
    ObjScanner good(in_pieces(good_line, piece));
    CHECK(all_tokens(good).size() == 4);
    ObjScanner bad(in_pieces(bad_line, piece));
    CHECK_THROWS_AS((void)all_tokens(bad), TokenTooLong);
  }
  ObjScanner good(longest);
  CHECK(good.next_statement() == longest);
  ObjScanner bad(too_long);
  CHECK_THROWS_WITH_AS((void)bad.next_statement(), doctest::Contains("a word of more than 1048576 bytes: \"7777"),
                       TokenTooLong);
}

TEST_CASE("bytes that lead are skipped once, from a text and from a source") {
  ObjScanner text("\xEF\xBB\xBFv");
  CHECK_FALSE(text.skip("\xFF\xFE"));
  CHECK(text.skip("\xEF\xBB\xBF"));
  CHECK(text.next_statement() == "v");
  ObjScanner source(in_pieces("\xEF\xBB\xBFv", 1));
  CHECK_FALSE(source.skip("\xFF\xFE"));
  CHECK(source.skip("\xEF\xBB\xBF"));
  CHECK(source.next_statement() == "v");
  ObjScanner shorter(in_pieces("v", 1));
  CHECK_FALSE(shorter.skip("\xEF\xBB\xBF"));
  CHECK(shorter.next_statement() == "v");
}

}  // namespace

}  // namespace sightline::tests::obj_scanner_test
