// Smooth mirrors of all visible polygons, until the tolerance is kept.
//
// In:  a world with normals, a view's scene, its visible polygons by their borders.
// Out: per polygon and panel what reflects; per panel how much of that may be wrong, and how far a border may be off.
// Holds: per panel at most the tolerance's share of the reflecting area is uncertain, and no border is further than the tolerance,
//      in half windows, from where it should be; or all cells are as small as the grid allows, or there were a hundred rounds, or what is uncertain is less than
//      2^-30 of the window.
// Method: rounds. In each the cells are divided, of all polygons, that are at least half as uncertain as the most uncertain one. Once
//      there is little enough together, borders are made.
// Complexity: that of lit_cells.h for all cells, and a look at each of them per round.
#pragma once

#include <functional>
#include <vector>

#include "reflect/smooth/smooth_mirror.h"

namespace sightline::inline reflect {

// A visible polygon is looked at by its surface and its border.
struct MirrorPolygon {
  FacetId surface;
  RegionBorder border;
};

struct SmoothReflections {
  std::vector<std::vector<Reflecting>> found;  // per polygon, per panel
  std::vector<Reflecting> together;            // per panel: without a border
};

// Polygons of one surface follow each other.
[[nodiscard]] SmoothReflections find_smooth_reflections(const MirrorWorld& world, const ProjectedScene& scene,
                                                        const std::vector<MirrorPolygon>& polygons,
                                                        ReflectionStatistics& statistics);

}  // namespace sightline::inline reflect
