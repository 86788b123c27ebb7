// Facets hidden behind others, cell by cell.
//
// In:  a scene in cells, with the facets that are known to be hidden.
// Out: per facet whether it is certainly hidden; not all hidden facets are found. Per cell whether it has one sheet: if no
//      contour edge of what may be seen touches such a cell, then all that is seen in it are facets that continue each other,
//      and all that is of them in the cell is seen.
// A cover of a cell is a set of facets that continue each other and cover the cell without a contour edge in it. In front in
// the cell are the cover's facets, and whatever is neither deeper than all of the cover nor behind everything in front that
// it overlaps. A surface is hidden where none of its facets is in front in any cell.
// Holds: leaving the hidden facets out changes no top cycle and no topmost facet (node_list.h), whatever the order of depth
//      says: docs/covers.md has the proof, in lemmas. What is deeper than all of the cover is out of range (lemma 6); what is
//      behind all in front is in no top cycle (lemma 7), nor does anything that is in front come into range without it (the
//      theorem). So also where facets overlap in the rounded image only, and their order is no order.
//      What is said of one sheet holds where the cover covers the cell once (lemmas 9 to 11), and that is asked of its centre.
//      Of one surface all facets are hidden or none, so that all edges that may carry its segments are there (lemma 8).
// Complexity: O(n + pairs of a facet and a cell that it touches), in each cell the sheets over its centre, sorted, and the
//      pairs of what is in front and what is no deeper than the cover.
// Source: docs/design.md, section 8, idea 2. Rejected: to call hidden what continues, within the cell, a facet that is behind
// the cover over its centre. That holds in space, and not in the rounded image, where slivers may overlap on the wrong side.
#pragma once

#include <vector>

#include "sweep/fast/scene_in_cells.h"

namespace sightline::inline sweep {

struct Covers {
  std::vector<std::uint8_t> hidden;     // per facet; with those that were known
  std::vector<std::uint8_t> one_sheet;  // per cell
};

[[nodiscard]] Covers find_covers(const SceneInCells& in);

}  // namespace sightline::inline sweep
