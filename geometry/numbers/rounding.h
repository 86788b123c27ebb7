// This is what one operation in double may be off by: the unit in which the error bounds of the project are stated.
#pragma once

#include <limits>

namespace sightline::inline geometry {

// It is half a unit in the last place of 1: the relative error of one rounded operation.
constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;
static_assert(unit_roundoff == 0x1p-53);

}  // namespace sightline::inline geometry
