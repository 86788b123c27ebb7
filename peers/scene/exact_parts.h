// What is exactly visible is given as the peers say it: in the window's coordinates, rounded to double.
#pragma once

#include "peers/scene/errors_of_areas.h"
#include "peers/scene/seen.h"
#include "reconstruct/polygons/visible_polygons.h"

namespace sightline::peers {

// The parts are sorted by face. Polygons below resolution are in it.
[[nodiscard]] VisibleParts visible_parts(const ProjectedScene& scene, const VisibleSegments& segments,
                                         const VisiblePolygons& polygons);

struct ExactParts {
  VisibleParts parts;
  VisibleLines lines;  // each point of an edge once, whichever of its faces' segments run along it
  FaceAreas areas;     // of the faces that are called visible: some polygon of theirs is not below resolution
};

[[nodiscard]] ExactParts exact_parts(const ProjectedScene& scene, const VisibleSegments& segments,
                                     const VisiblePolygons& polygons);

}  // namespace sightline::peers
