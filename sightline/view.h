// A view is all that is known of how a camera sees a surface.
#pragma once

#include "geometry/projection/culling.h"
#include "geometry/projection/projected_scene.h"
#include "reconstruct/labelling/labelled_mesh.h"
#include "reconstruct/polygons/visible_polygons.h"
#include "reflect/reflections.h"
#include "sweep/segments/visible_segments.h"

namespace sightline {

// The visibility is what a camera sees: all that the sweep finds.
struct Visibility {
  SidesDecision sides;
  ProjectedScene scene;
  VisibleSegments segments;
  VisiblePolygons polygons;

  // The surface; on a grid without facets that pass through each other.
  [[nodiscard]] const CutMesh& mesh() const { return scene.mesh(); }
};

// Where panels are reflected, scene and segments have their borders, too.
struct View : Visibility {
  LabelledMesh labelled;
  Reflections reflections;
};

}  // namespace sightline
