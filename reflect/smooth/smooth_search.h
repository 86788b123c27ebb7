// Smooth mirrors of all visible polygons, until the tolerance is kept.
//
// In:  a world with normals, a view's scene, its visible polygons by their borders.
// Out: per polygon and panel what reflects; per panel how much of that may be wrong, and how far a border may be off.
// Holds: per panel at most the tolerance's share of the reflecting area is uncertain, and no border is further than the tolerance,
//      in half windows, from where it should be; or all cells are as small as the grid allows, or there were twenty rounds, or what is uncertain is less than
//      2^-30 of the window.
// Method: rounds. In each a cell may have a share of what may be uncertain in all; where they have too much together, the polygons
//      that have any are looked at again, with smaller shares.
// Complexity: that of the last round, but for a factor.
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
  std::vector<std::vector<SmoothMirror::Reflecting>> found;  // per polygon, per panel
  std::vector<SmoothMirror::Reflecting> together;            // per panel: without a border
};

// Polygons of one surface follow each other.
[[nodiscard]] SmoothReflections find_smooth_reflections(const MirrorWorld& world, const ProjectedScene& scene,
                                                        const std::vector<MirrorPolygon>& polygons,
                                                        ReflectionStatistics& statistics);

}  // namespace sightline::inline reflect
