// An OBJ file goes through the command itself, and is held against the same row as the reader (obj_case.h).
#pragma once

#include <string>

#include "tests/tools/command_runner.h"
#include "tests/tools/obj_case.h"

namespace sightline::tests {

// Runs `sightline analyze` with a camera that sees all of the mesh, both sides of its faces, and the report on standard
// output. `results` is a folder for the results.
[[nodiscard]] tests::RunResult analyze_all_of(const std::filesystem::path& file, const std::string& results);

// Returns whether it is one line that starts so, and nothing else.
[[nodiscard]] bool is_error_line(const std::string& err, const std::string& start);

// The command refuses the file with its name, the line and the cause, and leaves no results; or it reads it, says in
// its report what is skipped, and sees some of it where there is something to see.
void check_command(const std::filesystem::path& folder, const ObjCase& c);

// A file without a row is checked in the same way: what the reader does with it, the command does too.
void check_command_does_as_reader(const std::filesystem::path& file);

}  // namespace sightline::tests
