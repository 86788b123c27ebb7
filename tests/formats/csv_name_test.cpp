// Names in CSV: none is a formula or a date to a spreadsheet, and each is found again.
#include "formats/writing/csv_name.h"

#include <doctest/doctest.h>

#include <string>

namespace sightline::tests::csv_name_test {
namespace {

// Reads a cell as RFC 4180 has it, and takes the apostrophe away.
std::string read_back(std::string cell) {
  if (cell.starts_with('"')) {
    std::string inside;
    for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
      if (cell[i] == '"') ++i;
      inside += cell[i];
    }
    cell = inside;
  }
  return cell.starts_with('\'') ? cell.substr(1) : cell;
}

}  // namespace

TEST_CASE("names that a spreadsheet would run, or take for a date or a number, have an apostrophe") {
  for (const char* name : {"=1+1", "+cmd", "-2", "@sum", "'quoted", "3-7", "1/2", "2024-01-01", "MAR1", "sept-2",
                           "1 jan 2020", "1e5", "3.5", "10:30", "12 pm", "=HYPERLINK(\"http://x\",\"y\")"}) {
    INFO(name);
    const std::string cell = csv_name(name);
    CHECK((cell.starts_with("'") || cell.starts_with("\"'")));
    CHECK(read_back(cell) == name);
  }
}

TEST_CASE("other names stay what they are; commas, quotation marks and blanks are quoted") {
  for (const char* name :
       {"", "body", "12", "007", "march", "wheel_2", "Box01", "3D body", "a=b", "x-1", "K\xC3\xB6rper"})
    CHECK(csv_name(name) == name);
  CHECK(csv_name("a, b") == "\"a, b\"");
  CHECK(csv_name("say \"a\"") == "\"say \"\"a\"\"\"");
  CHECK(csv_name(" a") == "\" a\"");
  CHECK(csv_name("a;b") == "\"a;b\"");
  CHECK(read_back(csv_name("=a,\"b\"")) == "=a,\"b\"");
}

}  // namespace sightline::tests::csv_name_test
