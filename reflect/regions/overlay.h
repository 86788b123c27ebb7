// The overlay finds what two regions of the image have in common, exactly.
//
// In:  the borders of two regions, in directed segments: closed rings with the region to their left. The first region's
//      segments meet in end points only. Those of the second may lie on and across each other; a place is in it where its
//      segments wind around it more than zero times.
// Out: the border of the common part, in segments that meet in end points only, with the part to their left. A segment lies
//      on the line of the one that it came from. Empty where the regions have no area in common.
// Complexity: O((m + n + k) b) for m and n segments that meet k times, of which b are beside each other at one height
// (BandIndex in overlay.cpp): small regions, or small segments.
#pragma once

#include <vector>

#include "reflect/regions/image_place.h"

namespace sightline::inline reflect {

[[nodiscard]] RegionBorder common_part(const RegionBorder& first, const RegionBorder& second);

// Leaves out the segments that run back and forth between the same places: the border winds around everything as before.
// It takes O(n log n).
[[nodiscard]] RegionBorder without_seams(RegionBorder border);

// Divides borders, whose segments meet those of their own border in end points only, so that they meet each other's in
// end points only, or lie on each other from end to end. It takes O(n^2) for n segments.
[[nodiscard]] std::vector<RegionBorder> divided_at_meetings(std::vector<RegionBorder> borders);

}  // namespace sightline::inline reflect
