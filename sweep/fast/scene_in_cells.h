// A scene as the fast engine looks at it: cell by cell.
//
// In:  a projected scene that outlives it.
// Out: where its surface continues, its depths, what single large facets hide, a grid of cells, and the cells of all other
//      facets.
// Holds: cells are as fine as so many pairs of a facet and a cell in its bounding box allow, per facet in view: contour
//      edges then touch few of them, and looking at all pairs still costs little.
// Complexity: O(n log n) and the cells that facets touch.
// Source: docs/design.md, section 8.
#pragma once

#include <optional>
#include <vector>

#include "geometry/projection/projected_scene.h"
#include "sweep/fast/cell_grid.h"
#include "sweep/fast/cell_sides.h"
#include "sweep/fast/continuation.h"
#include "sweep/fast/facet_cells.h"
#include "sweep/plain/depth_ranges.h"

namespace sightline::inline sweep {

struct SceneInCells {
  // The level is the grid's, where it is not to be found (cell_grid.h).
  explicit SceneInCells(const ProjectedScene& whole, std::optional<int> level = std::nullopt);

  // Those facets are hidden which are said to be, and no others.
  SceneInCells(const ProjectedScene& whole, int level, std::vector<std::uint8_t> known_hidden);

  const ProjectedScene& scene;
  const CellSides sides;
  const Continuation continuation;
  const std::vector<DepthRange> depths;
  const std::vector<std::uint8_t> hidden;  // per facet; of a surface all facets or none
  const CellGrid grid;
  const FacetCells cells;

  [[nodiscard]] const CutMesh& mesh() const { return scene.mesh(); }
};

// Leaves no facet hidden, per facet, of a surface (facet_plane.h) some of whose facets in view may be seen. What the
// sweep says of a surface it says of all its facets: a segment's edge may belong to any of them, and where the boundary
// of what is visible passes an edge, the edge is split for all facets on it. This takes O(n).
void keep_surfaces_whole(const ProjectedScene& scene, std::vector<std::uint8_t>& hidden);

}  // namespace sightline::inline sweep
