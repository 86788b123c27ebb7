// The open facets, parted into bands of the image that are swept each by itself.
//
// In:  a scene in cells, and the roles of its facets; how many bands.
// Out: per open facet its band; per band the facets that its sweep has to know.
// Holds: the facets of one surface are in one band. A band's sweep knows all facets that may be seen in the cells which
//      the band's open facets touch, so what it says of these is right, and nothing has to be joined at the bands'
//      borders: a facet that reaches into several bands is swept whole in one.
// Complexity: O(n) and the cells that facets touch.
// Source: docs/design.md, section 8, idea 3. Rejected: sweeps that start at a line from the edges that cross it; what is
// open there has to be found first, and segments that cross the line have to be joined.
#pragma once

#include <vector>

#include "sweep/fast/roles.h"
#include "sweep/fast/scene_in_cells.h"

namespace sightline::inline sweep {

constexpr std::size_t most_bands = 64;

using BandId = Id<struct BandTag>;

struct Bands {
  std::vector<BandId> band_of;              // per facet; invalid but for open ones
  std::vector<std::vector<FacetId>> swept;  // per band, by id
};

// There is at least one band, and there are at most most_bands.
[[nodiscard]] Bands make_bands(const SceneInCells& in, const std::vector<Role>& roles, std::size_t count);

// Makes as many bands as pay, whatever the number of threads is.
[[nodiscard]] Bands make_bands(const SceneInCells& in, const std::vector<Role>& roles);

}  // namespace sightline::inline sweep
