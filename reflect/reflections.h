// Reflections: which part of what the camera sees mirrors which panel into it.
//
// In:  a view: projected scene and visible segments, which are taken over (copied unless they are moved), and visible
//      polygons; the panels and what may be in their way (MirrorWorld).
// Out: per panel its reflecting polygons, and the view's scene and segments with the points and lines that these need
//      (merged_scene.h); the ids of facets, segments and polygons stay what they were.
// Holds: a reflecting polygon lies in a visible polygon of its face, and shares its points where it runs along its
//      border; what splits a mesh edge is among the segments' splits, so that the labelled surface stays conforming.
//      Polygons of different panels do not overlap: of panels that lie in one plane, on each other, the first one is in front.
// Modes: exact or smooth (reflection_options.h); marking triangles comes after labelling (reflecting_triangles.h).
// Complexity: O(1) per visible polygon and panel where the pyramid misses the panel; else a search among the obstacles,
// and what overlay.h and the sweep of their shadows cost (exact), or per cell into which smooth_search.h has it divided.
// Then that of merged_scene.h, and O(m v) to find where the m points of a surface split its v visible edges.
// Errors: InternalError; in float and double ArithmeticError instead.
// Source: Koucky 2014, 3.9; see mirror.h and smooth_mirror.h for the departures.
#pragma once

#include <vector>

#include "geometry/numbers/export.h"
#include "reconstruct/labelling/labelled_mesh.h"
#include "reflect/world/mirror_world.h"

namespace sightline::inline reflect {

struct PanelReflection {
  VisibleSegments segments;  // the borders of the reflecting polygons; their points are the merged scene's
  VisiblePolygons polygons;
  // Of smooth mirrors, in window units: how much of the reflecting area may be wrong, that of all polygons together; and how far
  // a border may be from where it should be.
  double uncertain_area = 0;
  double border_distance = 0;
};

struct Reflections {
  ReflectionMode mode = ReflectionMode::exact;
  std::vector<PanelReflection> panels;  // parallel to the world's; without polygons where triangles are marked
  ReflectionStatistics statistics;
};

struct ReflectedView {
  ProjectedScene scene;
  VisibleSegments segments;
  Reflections reflections;
};

[[nodiscard]] SIGHTLINE_EXPORT ReflectedView find_reflections(const MirrorWorld& world, ProjectedScene scene,
                                                              VisibleSegments segments,
                                                              const VisiblePolygons& polygons);

// Returns the borders of the reflecting polygons above resolution, as label_mesh wants them.
[[nodiscard]] SIGHTLINE_EXPORT PanelBorders panel_borders(const Reflections& reflections);

}  // namespace sightline::inline reflect
