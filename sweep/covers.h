// Facets hidden behind a sheet of facets that covers all of a cell of the image.
//
// In:  a mesh whose contacts are known, its projected scene, its depth ranges, where the surface continues, a grid of
//      cells and the cells of facets, and facets that are known to be hidden.
// Out: per facet 1 where it is certainly hidden, those that were given included. Not all hidden facets are found.
// Holds: leaving the hidden facets out of the sweep changes nothing that is visible. A cover of a cell is a set of facets
//      that continue each other and cover the cell without a contour edge in it. Hidden in the cell is
//      - what is deeper than all of the cover,
//      - what lies behind the cover by the exact order of depth, where that is one facet, and
//      - what continues, within the cell, a facet that lies behind the cover over the cell's centre: it could come in
//        front only by passing through the cover, or around an end of it. Facets that touch others stop this.
//      A facet is hidden where it is hidden in all the cells it touches. A cover is never hidden in its own cell.
// Complexity: O(n + pairs of a facet and a cell that it touches), and in each cell the sheets over its centre, sorted.
// Source: DESIGN.md section 8, idea 2.
#pragma once

#include <vector>

#include "geometry/mesh.h"
#include "geometry/projected_scene.h"
#include "sweep/cell_grid.h"
#include "sweep/continuation.h"
#include "sweep/depth_ranges.h"
#include "sweep/facet_cells.h"

namespace sightline {

[[nodiscard]] std::vector<std::uint8_t> hidden_behind_covers(const Mesh& mesh, const ProjectedScene& scene,
                                                             const std::vector<DepthRange>& depths,
                                                             const Continuation& continuation, const CellGrid& grid,
                                                             const FacetCells& cells, std::vector<std::uint8_t> hidden);

}  // namespace sightline
