// How far drawn lines are from those that are exactly visible: by length.
//
// In:  lines in the window's coordinates, each point of a line once.
// Out: shares of the length of the visible lines: of what is missing, and of what is drawn and is not visible.
// Method: what two lines have in common is an interval where they lie on one line, to within `same_line` of the window:
//      this measures results that were rounded, it decides nothing of them.
// Complexity: O(lines + pairs of them whose boxes share a cell of a grid).
#pragma once

#include "peers/scene/exact_parts.h"

namespace sightline::peers {

struct LineErrors {
  double length = 0;         // drawn, in window units
  double missing_share = 0;  // of the visible lines' length
  double hidden_share = 0;   // drawn though not visible, against the same length
};

constexpr double same_line = 1e-9;

[[nodiscard]] LineErrors errors_of(const VisibleLines& seen, const VisibleLines& exact);

}  // namespace sightline::peers
