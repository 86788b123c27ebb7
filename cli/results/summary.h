// The summary tells a person at the end how it went: a table of at most 80 columns, one line per camera, and where to look.
#pragma once

#include <string>
#include <vector>

#include "cli/results/region_measures.h"
#include "cli/results/report.h"
#include "coverage/coverage.h"

namespace sightline::cli {

// reports: of the cameras of one scene, at least one; coverage, regions: of the same. output: the folder of the results.
// with_page: report.html is there.
[[nodiscard]] std::string summary(const std::vector<Report>& reports, const Coverage& coverage,
                                  const SeenRegions& regions, const std::string& output, bool with_page);

}  // namespace sightline::cli
