// compare.html: what each peer does, what it got, and what that cost; the pictures and the plot beside it.
#pragma once

#include <string>

#include "cli/compare/comparison.h"

namespace sightline::cli {

// HTML; the pictures are files beside it (picture_name).
[[nodiscard]] std::string compare_page(const Comparison& comparison);

// The trade as a picture, SVG: error against time, log-log, a curve per peer. The sweep on its grids is one curve; peers
// whose result is lines have no error of areas and are left out.
[[nodiscard]] std::string compare_plot(const Comparison& comparison);

}  // namespace sightline::cli
