// sightline runs next to its limits and its rivals, on the same inputs, in one run, each on one thread but where
// threads are compared.
//
//     build/release/bench/sightline_side_by_side [--quick] [--sizes N,N,...] [--only sphere,terrain,...] [--help]
//
// Prints Markdown: per family of scenes the seconds of each stage and of each rival, the ratios, and which goals are
// reached. Times are of the processor, not of the clock on the wall, medians of several runs. "> 60" is a run that was
// stopped.

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cstdio>
#include <exception>

#include "bench/measuring/machine.h"
#include "bench/side_by_side/side_by_side_goals.h"
#include "bench/side_by_side/side_by_side_tables.h"

namespace sightline::bench {
namespace {

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

void measure_all(const SideBySideOptions& options) {
  print(fmt::format("{}. Seconds of one processor; the median of {}, each ended after {} s.\n\n", machine_line(),
                    options.limits.runs == 1 ? "one run" : fmt::format("{} runs", options.limits.runs),
                    options.limits.seconds));
  CommandResult command;
  if (is_wanted(options, "threads")) {
    command.threads = measure_threads(options.sizes.back(), options.limits);
    print(threads_table(options.sizes.back(), *command.threads));
  }
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::vector<FamilyResult> results;
  for (const SceneFamily& family : scene_families(options)) {
    results.push_back(measure_family(family, options));
    print(family_tables(results.back()));
  }
  if (is_wanted(options, "reflection")) {
    command.reflection = measure_reflection(options.mirrors, options.limits);
    print(reflection_table(options.mirrors, *command.reflection));
  }
  if (is_wanted(options, "writing")) {
    command.writing = measure_writing(options.sizes.back(), options.limits);
    print(writing_table(options.sizes.back(), *command.writing));
  }
  print(goals_table(results, command));
}

}  // namespace
}  // namespace sightline::bench

int main(int argc, char** argv) {
  try {
    sightline::bench::measure_all(sightline::bench::parse_side_by_side_options(argc, argv));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sightline_side_by_side: %s\n", error.what());
    return 1;
  }
}
