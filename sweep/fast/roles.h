// What the sweep has to look at.
//
// In:  a mesh, its projected scene, where the surface continues, what covers hide, a grid of cells and the cells of
//      facets.
// Out: per facet its role.
// Holds: in the cells that a plain facet touches one sheet is seen, its own, and no contour edge of what may be seen is
//      there; so all of it is seen, and its neighbours are seen along its edges (docs/covers.md, lemma 11).
// Complexity: O(n) and the cells that contour edges touch.
// Source: docs/design.md, section 8, idea 1.
#pragma once

#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/projection/projected_scene.h"
#include "sweep/fast/cell_grid.h"
#include "sweep/fast/continuation.h"
#include "sweep/fast/covers.h"
#include "sweep/fast/facet_cells.h"

namespace sightline::inline sweep {

// The role says what becomes of a facet. A role that is not listed here does not exist.
enum class Role : std::uint8_t {
  absent,  // not in view
  hidden,  // behind covers
  plain,   // seen whole
  open,    // the sweep decides
};

[[nodiscard]] std::vector<Role> find_roles(const ProjectedScene& scene, const Continuation& continuation,
                                           const Covers& covers, const CellGrid& grid, const FacetCells& cells);

}  // namespace sightline::inline sweep
