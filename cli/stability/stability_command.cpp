#include "cli/stability/stability_command.h"

#include <fmt/format.h>

#include <array>

#include "cli/stability/stability_report.h"
#include "cli/system/progress.h"
#include "cli/system/result_folders.h"

namespace sightline::cli {

namespace {

FamilyRuns runs_of(const ExtremeFamily& family, Progress& progress) {
  FamilyRuns runs{&family, {}};
  for (const double value : family.values) {
    progress.stage(fmt::format("{}: {:.3g}", family.title, value));
    for (const Arithmetic arithmetic : arithmetics) runs.runs.push_back(run_stability(family, value, arithmetic));
  }
  return runs;
}

void write_results(const std::vector<FamilyRuns>& all, const std::string& output) {
  OutputFolder folder = output_folder_at(output);
  folder.write("stability.csv", stability_table(all));
  for (const FamilyRuns& runs : all) folder.write(runs.family->name + ".svg", stability_plot(runs));
  folder.write("stability.html", stability_page(all));
  folder.publish();
}

std::string summary(const std::vector<FamilyRuns>& all, const std::string& output) {
  std::string text;
  for (const FamilyRuns& runs : all) {
    text += runs.family->title + "\n";
    for (const Arithmetic arithmetic : arithmetics) text += "  " + finding(runs, arithmetic) + "\n";
  }
  return text + output + "/stability.html has the plots\n";
}

}  // namespace

std::string stability_command(const StabilityOptions& options) {
  Progress progress(!options.quiet && Progress::watched());
  std::vector<FamilyRuns> all;
  for (const ExtremeFamily& family : extreme_families()) {
    if (!options.family || *options.family == family.name) all.push_back(runs_of(family, progress));
  }
  progress.stage("write the results");
  write_results(all, options.output);
  return options.quiet ? "" : summary(all, options.output);
}

}  // namespace sightline::cli
