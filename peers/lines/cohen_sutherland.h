// Line clipping by Cohen and Sutherland: which part of a line is in an upright window.
//
// In:  a line, a window.
// Out: the part in the window, its border included, in the line's direction; nothing where there is none. An end that
//      is in the window stays as it is; a new end lies exactly on the border it was cut at.
// Each end gets an outcode; two trivial cases are decided by the outcodes alone, else the line is cut at one of the
// window's lines, tried from top to bottom and from right to left, and what is outside is thrown away.
// Precision: object. Floating point: a new end is off by some roundings, and so a line that passes the window's
// corner by less than that may be called seen in a point, or not seen.
// Cost: at most four cuts. Those that are outside the window's other lines are wasted (the slides' point F).
// Source: slides 003, "Odsijecanje dužina", 1. Algoritam Cohen-Sutherlanda.
#pragma once

#include <cstdint>
#include <optional>

#include "peers/lines/window.h"

namespace sightline::peers {

// Bits 3210 say above, below, right of, left of the window.
using Outcode = std::uint8_t;
constexpr Outcode above_bit = 0b1000;
constexpr Outcode below_bit = 0b0100;
constexpr Outcode right_bit = 0b0010;
constexpr Outcode left_bit = 0b0001;

[[nodiscard]] Outcode outcode_of(const Point2& v, const Window& window);

[[nodiscard]] std::optional<Line> cohen_sutherland(const Line& line, const Window& window);

}  // namespace sightline::peers
