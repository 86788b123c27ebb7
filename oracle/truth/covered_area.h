// Exact areas of places that are told by which shapes cover them.
//
// In:  shapes, each a set of outlines that covers where their winding numbers add up to more than zero; the first is
//      the frame. `wanted` tells from the winding number of every shape whether a place counts.
// Out: the area of the places of the frame that count, in window units squared.
// How: slabs between all distinct y of corners and crossings; within a slab no two sides cross, so that from left to
//      right the winding numbers change at sides only. Area is the integral of x dy along the border of what counts,
//      and a side adds to it where it begins or ceases to be border.
// Exact: numbers are sorted by their first 60 binary places, rounded down, which keeps their order; equal ones are
//      compared exactly.
// Complexity: O(n^2) crossings for n sides, and O(n log n) in each slab.
#pragma once

#include <functional>
#include <vector>

#include "oracle/truth/outline.h"

namespace sightline::oracle::image {

using Rational = boost::multiprecision::cpp_rational;
using Shape = std::vector<Outline>;
using Wanted = std::function<bool(const std::vector<int>& windings)>;

[[nodiscard]] Rational area_where(const std::vector<Shape>& shapes, const Wanted& wanted);

}  // namespace sightline::oracle::image
