// What needs no sweep: facets that no contour edge comes near, in patches that are seen whole or not at all.
//
// In:  a mesh whose contacts are known (Mesh::touched), its projected scene, where the surface continues, the facets that
//      are known to be hidden, a grid of cells and the cells of facets.
// Out: per facet its role; per plain facet its patch.
// Holds:
//   - no contour edge of a facet that may be seen touches a cell that a plain facet touches. What is visible changes at
//     contour edges only, and where facets touch (never in a plain facet), so all of a plain facet is seen, or nothing,
//     and so are those that continue it: together a patch;
//   - each patch borders on an open facet, where the sweep's result tells whether the patch is seen.
// Complexity: O(n) and the cells that contour edges touch.
// Source: DESIGN.md section 8, idea 1.
#pragma once

#include <vector>

#include "geometry/mesh.h"
#include "geometry/projected_scene.h"
#include "sweep/cell_grid.h"
#include "sweep/continuation.h"
#include "sweep/facet_cells.h"

namespace sightline {

// What becomes of a facet. A role that is not listed here does not exist.
enum class Role : std::uint8_t {
  absent,  // not in view
  hidden,  // behind covers
  plain,   // of a patch
  open,    // the sweep decides
};

using PatchId = Id<struct PatchTag>;

struct Patches {
  std::vector<Role> role;         // per facet
  std::vector<PatchId> patch_of;  // per facet; invalid but for plain ones
  std::size_t patch_count = 0;
};

[[nodiscard]] Patches find_patches(const Mesh& mesh, const ProjectedScene& scene, const Continuation& continuation,
                                   const std::vector<std::uint8_t>& hidden, const CellGrid& grid,
                                   const FacetCells& cells);

}  // namespace sightline
