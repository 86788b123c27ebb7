// The command `sightline`. Exit codes: 0 done, 1 the input is wrong, 2 the command line is wrong, 3 internal error.

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "cli/analyze_command.h"
#include "cli/command_line.h"
#include "cli/compare/compare_command.h"
#include "cli/stability/stability_command.h"
#include "cli/system/durable_file.h"
#include "cli/trace/trace_command.h"

namespace cli = sightline::cli;

namespace {

enum ExitCode { done = 0, input_is_wrong = 1, command_line_is_wrong = 2, internal_error = 3 };

// One line, whatever names and texts from the input are in it.
int fail(ExitCode code, std::string message) {
  for (char& c : message) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  }
  std::fprintf(stderr, "sightline: %s\n", message.c_str());
  return code;
}

void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) throw cli::OutputError("standard output cannot be written");
}

int run(int argc, const char* const* argv) {
  const auto request = cli::parse_command_line(argc, argv);
  if (const auto* asked = std::get_if<cli::RequestedText>(&request)) {
    print(asked->text);
  } else if (const auto* stability = std::get_if<cli::StabilityOptions>(&request)) {
    print(cli::stability_command(*stability));
  } else if (const auto* compare = std::get_if<cli::CompareOptions>(&request)) {
    print(cli::compare_command(*compare));
  } else if (const auto* trace = std::get_if<cli::TraceOptions>(&request)) {
    print(cli::trace_command(*trace));
  } else {
    print(cli::analyze_command(std::get<cli::AnalyzeOptions>(request)));
  }
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit of the user's shell is an error of writing, not a crash
  try {
    return run(argc, argv);
  } catch (const cli::CommandLineError& error) {
    return fail(command_line_is_wrong, std::string(error.what()) + "; see sightline --help");
  } catch (const sightline::InternalError& error) {
    return fail(internal_error, std::string("internal error: ") + error.what() + "; please report it with the input");
  } catch (const sightline::Error& error) {
    return fail(input_is_wrong, error.what());
  } catch (const std::bad_alloc&) {
    return fail(internal_error, "out of memory");
  } catch (const std::exception& error) {
    return fail(internal_error, std::string("internal error: ") + error.what() + "; please report it with the input");
  }
}
