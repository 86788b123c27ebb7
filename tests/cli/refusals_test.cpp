// Every refusal of the library and the command ends with what to do. Their sources are read for them, so that a new one
// is held to it, too, though no test should run into it.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/tools/command_runner.h"
#include "tests/tools/says_what_to_do.h"
#include "tests/tools/source_statements.h"

namespace sightline::tests::refusals_test {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> places{"cli",
                                      "formats/reading",
                                      "formats/importing",
                                      "geometry/mesh/placement.cpp",
                                      "geometry/projection/affine_camera.cpp",
                                      "geometry/projection/camera.cpp",
                                      "geometry/projection/frame_cut.cpp",
                                      "geometry/projection/lens.cpp",
                                      "geometry/projection/lens_image.cpp",
                                      "peers/lines",
                                      "reflect/world/panel.cpp",
                                      "sightline/analyzer.cpp"};

// To what throws GltfError and std::runtime_error the reader of the file adds what to do; an InternalError is no refusal.
const std::regex refusing(R"re(\b(throw|return) (\w+::)*((?!Gltf|Internal)\w+Error|TokenTooLong|RefusedScene)\(|)re"
                          R"re(\b(fail|fail_head|fail_at_end|refuse|refuse_\w+|require|require_lens)\()re");

// Whatever is between literals stands in braces.
std::string message_in(const Statement& statement, std::size_t from) {
  std::string message;
  for (const Literal& literal : statement.literals) {
    if (literal.place > from) message += (message.empty() ? "" : "{}") + literal.text;
  }
  return message;
}

// A cause has a text of at least three words; with less, a statement passes another's message on.
bool has_cause(const Statement& statement, std::size_t from) {
  static const std::regex three_words(R"([A-Za-z]\S* .*[A-Za-z]\S* .*[A-Za-z])");
  return std::ranges::any_of(statement.literals, [&](const Literal& literal) {
    return literal.place > from && std::regex_search(literal.text, three_words);
  });
}

std::vector<fs::path> sources() {
  const fs::path root = fs::path(SIGHTLINE_FIXTURES_DIR).parent_path();
  std::vector<fs::path> files;
  for (const std::string& place : places) {
    REQUIRE(fs::exists(root / place));
    if (fs::is_regular_file(root / place)) {
      files.push_back(root / place);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(root / place)) {
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h") files.push_back(entry.path());
    }
  }
  return files;
}

// Returns how many refusals there are in the code, and checks each.
std::size_t check_refusals(const std::string& code, const std::string& file, std::vector<std::string>& silent) {
  std::size_t count = 0;
  for (const Statement& statement : statements_of(code)) {
    std::smatch found;
    if (!std::regex_search(statement.code, found, refusing)) continue;
    const auto from = static_cast<std::size_t>(found.position());
    if (!has_cause(statement, from)) continue;
    ++count;
    const std::string message = message_in(statement, from);
    if (says_what_to_do(message)) continue;
    silent.push_back(file);
    silent.back().append(":").append(std::to_string(statement.line)).append(": ").append(message);
  }
  return count;
}

}  // namespace

TEST_CASE("every refusal in the sources says what to do") {
  std::vector<std::string> silent;
  std::size_t count = 0;
  for (const fs::path& file : sources()) count += check_refusals(read_text(file), file.string(), silent);
  MESSAGE(count << " refusals");
  CHECK(count >= 330);
  for (const std::string& refusal : silent) FAIL_CHECK(refusal);
}

TEST_CASE("a refusal without a remedy is found, wherever it stands") {
  const auto silent_in = [](const std::string& code) {
    std::vector<std::string> silent;
    static_cast<void>(check_refusals(code, "a.cpp", silent));
    return silent;
  };
  CHECK(silent_in("if (c == '\"') x();\nthrow InputError(f, 1, \"the \\\"file\\\" \"\n  \"is empty\");") ==
        std::vector<std::string>{"a.cpp:2: the \"file\" is empty"});
  CHECK(silent_in("// throw\nif (!x)\n  table.fail(key, fmt::format(\"'{}' has more; no remedy is here\", key));")
            .size() == 1);
  CHECK(silent_in("if (c == '(' || n == 1'000) fail(\"a field has no end\");").size() == 1);
  CHECK(silent_in("require(f({1, 2}), name, \"up has length zero\");").size() == 1);
  CHECK(silent_in("require(x, name, \"up has length zero; give another\");").empty());
  CHECK(silent_in("fail(\"it needs \" + bytes + \" bytes of memory\" + \"; raise it\");").empty());
  CHECK(silent_in("throw InputError(file, 0, error.what());\nthrow InternalError(\"this is never so\");").empty());
}

TEST_CASE("what to do is asked for behind the last semicolon, or is what must be") {
  CHECK(says_what_to_do("a.obj:3: more than 3 vertices; divide the mesh"));
  CHECK(says_what_to_do("'emits' must be \"front\" or \"both\""));
  CHECK_FALSE(says_what_to_do("a.obj: cannot be opened"));
  CHECK_FALSE(says_what_to_do("too many; divide it; no mesh is so large"));
  CHECK_FALSE(says_what_to_do("a name; given twice"));
}

}  // namespace sightline::tests::refusals_test
