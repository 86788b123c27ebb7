// Painting: polygons over one another, the farthest first, so that what is seen of each is what is left of it.
//
// In:  flat polygons in the order in which they are painted. Out: an item buffer, and how many pixels were painted,
// each time anew that it was.
// Complexity: O(polygons + pixels painted * log resolution). Errors: none.
// Source: slides 001 ("draw the polygons in order from back to front", displayPolygon).
#pragma once

#include <cstdint>
#include <vector>

#include "peers/scene/flat_scene.h"
#include "peers/scene/seen.h"

namespace sightline::peers {

using BackToFront = std::vector<FlatPolygon>;

struct Painting {
  ItemBuffer buffer;
  std::uint64_t pixels_painted = 0;
};

[[nodiscard]] Painting paint(const BackToFront& polygons, int resolution);

}  // namespace sightline::peers
