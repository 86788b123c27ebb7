// `sightline stability` writes a table, a plot per family, and a page with everything.
//
// In:  the families' runs: for each family, by value, then by arithmetic. Out: texts, equal in every run but for the
//      times.
#pragma once

#include <string>
#include <vector>

#include "cli/stability/stability_run.h"

namespace sightline::cli {

struct FamilyRuns {
  const ExtremeFamily* family = nullptr;
  std::vector<StabilityRun> runs;
};

// stability.csv: a row per run. Areas are parts of the window; empty where the run did not finish.
[[nodiscard]] std::string stability_table(const std::vector<FamilyRuns>& all);

// Mislabelled area against the parameter, a curve per arithmetic, and the bound of what the grid explains.
[[nodiscard]] std::string stability_plot(const FamilyRuns& runs);

// Says in one sentence what one arithmetic did in a family.
[[nodiscard]] std::string finding(const FamilyRuns& runs, Arithmetic arithmetic);

// Self-contained HTML.
[[nodiscard]] std::string stability_page(const std::vector<FamilyRuns>& all);

}  // namespace sightline::cli
