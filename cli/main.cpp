// The command `sightline`. Exit codes: 0 done, 1 the input is wrong, 2 the command line is wrong, 3 internal error.

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <variant>

#include "cli/analyze_command.h"
#include "cli/command_line.h"
#include "cli/compare/compare_command.h"
#include "cli/stability/stability_command.h"
#include "cli/system/durable_file.h"
#include "cli/trace/trace_command.h"

namespace sightline::cli {

namespace {

enum ExitCode { done = 0, input_is_wrong = 1, command_line_is_wrong = 2, internal_error = 3 };

// Does what is asked for. Returns what belongs on standard output.
struct Command {
  std::string operator()(const AnalyzeOptions& options) const { return analyze_command(options); }
  std::string operator()(const CompareOptions& options) const { return compare_command(options); }
  std::string operator()(const StabilityOptions& options) const { return stability_command(options); }
  std::string operator()(const TraceOptions& options) const { return trace_command(options); }
  std::string operator()(const RequestedText& asked) const { return asked.text; }
};

void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) throw OutputError("standard output cannot be written; direct it elsewhere");
}

// One line, whatever names and texts from the input are in it.
ExitCode fail(ExitCode code, std::string message) {
  for (char& c : message) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  std::fprintf(stderr, "sightline: %s\n", message.c_str());
  return code;
}

ExitCode fail_internally(const std::exception& error) {
  return fail(internal_error, std::string("internal error: ") + error.what() + "; report it with the input");
}

ExitCode run(int argc, const char* const* argv) {
  try {
    print(std::visit(Command(), parse_command_line(argc, argv)));
    return done;
  } catch (const CommandLineError& error) {
    return fail(command_line_is_wrong, std::string(error.what()) + "; see sightline --help");
  } catch (const InternalError& error) {
    return fail_internally(error);
  } catch (const Error& error) {
    return fail(input_is_wrong, error.what());
  } catch (const std::bad_alloc&) {
    return fail(internal_error, "out of memory; close other programs, or take a smaller mesh");
  } catch (const std::exception& error) {
    return fail_internally(error);
  }
}

}  // namespace

}  // namespace sightline::cli

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit of the user's shell is an error of writing, not a crash
  return sightline::cli::run(argc, argv);
}
