// report.json: a report as JSON. A number beyond the range of double is null.
#pragma once

#include <string>

#include "cli/results/json.h"
#include "cli/results/report.h"

namespace sightline::cli {

[[nodiscard]] Json report_json(const Report& report);

[[nodiscard]] std::string report_text(const Report& report);

}  // namespace sightline::cli
