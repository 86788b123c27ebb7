// Roles say what the sweep has to look at.
//
// In:  a scene in cells, and what covers hide in it.
// Out: per facet its role.
// Holds: in the cells that a plain facet touches one sheet is seen, its own, and no contour edge of what may be seen is
//      there; so all of it is seen, and its neighbours are seen along its edges (docs/covers.md, lemma 11).
// Complexity: O(n) and the cells that contour edges touch.
// Source: docs/design.md, section 8, idea 1.
#pragma once

#include <vector>

#include "sweep/fast/covers.h"
#include "sweep/fast/scene_in_cells.h"

namespace sightline::inline sweep {

// The role says what becomes of a facet. A role that is not listed here does not exist.
enum class Role : std::uint8_t {
  absent,  // not in view
  hidden,  // behind covers
  plain,   // seen whole
  open,    // the sweep decides
};

[[nodiscard]] std::vector<Role> find_roles(const SceneInCells& in, const Covers& covers);

}  // namespace sightline::inline sweep
