// Facets hidden behind single large ones.
//
// In:  a projected scene and its depth ranges.
// Out: per facet 1 where it is certainly hidden: all cells that it touches, of a grid of fixed size, are covered by single
//      facets that are nearer than all of it. Not all hidden facets are found.
// Holds: leaving the hidden facets out of the sweep changes nothing that is visible: they are out of range wherever they
//      are (node_list.h), and the nearest cover of a cell is never hidden itself (docs/covers.md, lemma 2).
// Complexity: O(n log n) and the cells that facets touch which are not hidden; for the others mostly a few tiles, each of
//      many cells. So of a deep pile of facets most cost one look.
// Source: docs/design.md, section 8, idea 2; Greene, Kass and Miller 1993 (a hierarchy of depths).
#pragma once

#include <vector>

#include "geometry/projection/projected_scene.h"
#include "sweep/fast/cell_sides.h"
#include "sweep/plain/depth_ranges.h"

namespace sightline::inline sweep {

[[nodiscard]] std::vector<std::uint8_t> hidden_behind_large_facets(const ProjectedScene& scene, const CellSides& sides,
                                                                   const std::vector<DepthRange>& depths);

}  // namespace sightline::inline sweep
