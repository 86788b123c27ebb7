// The trade as a picture: error against time, log-log, a curve per peer.
#pragma once

#include <string>

#include "cli/compare/comparison.h"

namespace sightline::cli {

// SVG. The sweep on its grids is one curve; peers whose result is lines have no error of areas and are left out.
[[nodiscard]] std::string compare_plot(const Comparison& comparison);

}  // namespace sightline::cli
