// Line clipping by Cyrus and Beck: which part of a line is in a convex polygon, by the line's parameter.
//
// In:  a line P0 P1, and a convex polygon (counter-clockwise, no two neighbouring corners equal) or an upright
//      window.
// Out: [tE, tL] and the part of the line there, the border included; nothing where there is none.
// Where the line crosses the line of the edge E_i with the outward normal N_i, t = N_i . (P0 - P_Ei) / (-N_i . D)
// with D = P1 - P0. It potentially enters there (PE) where N_i . D < 0 and potentially leaves (PL) where N_i . D > 0.
// The last entry tE and the first exit tL bound the part; tE > tL: nothing is seen. A line that is parallel to E_i,
// or a point (D = 0), has no such t: it is not seen where it is outside, N_i . (P0 - P_Ei) > 0.
// Precision: object. Floating point: t is off by some roundings, for an end on the border, too.
// Cost: one division per edge, O(n) for n edges; all of them, where Cohen-Sutherland often needs none.
// Errors: std::invalid_argument for an edge without a normal (N_i = 0).
// Source: slides 003, "Odsijecanje dužina", 2. Algoritam Cyrus-Beck; the table there for the upright window.
#pragma once

#include <optional>
#include <span>

#include "peers/lines/window.h"

namespace sightline::peers {

struct ClippedLine {
  double tE = 0;
  double tL = 1;
  Line line;
};

[[nodiscard]] std::optional<ClippedLine> cyrus_beck(const Line& line, std::span<const Point2> polygon);
[[nodiscard]] std::optional<ClippedLine> cyrus_beck(const Line& line, const Window& window);

}  // namespace sightline::peers
