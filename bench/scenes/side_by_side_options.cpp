#include "bench/scenes/side_by_side_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>

namespace sightline::bench {

SideBySideOptions parse_side_by_side_options(int argc, const char* const* argv) {
  SideBySideOptions options;
  bool quick = false;
  bool without_rivals = false;
  CLI::App app("sightline next to its limits and its rivals, on the same inputs", "sightline_side_by_side");
  app.add_option("--sizes", options.sizes, "Numbers of triangles")->delimiter(',')->check(CLI::Range(100, 10000000));
  app.add_option("--limit", options.limits.seconds, "Seconds of processor time that one run may take")
      ->check(CLI::PositiveNumber);
  app.add_option("--runs", options.limits.runs, "Of so many runs the median is taken")->check(CLI::PositiveNumber);
  app.add_option(
         "--only", options.only,
         "Scenes: sphere, terrain, shrinking-soup, deep-soup, sheets, leaves, models; threads, reflection, writing")
      ->delimiter(',');
  app.add_flag("--without-rivals", without_rivals, "Measure sightline alone");
  app.add_flag("--quick", quick, "Small sizes, one run of at most ten seconds");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  std::sort(options.sizes.begin(), options.sizes.end());
  options.rivals = !without_rivals;
  if (quick) {
    options.sizes = {1000, 3000, 10000};
    options.mirrors = 10000;
    options.limits = {10, 1};
  }
  return options;
}

}  // namespace sightline::bench
