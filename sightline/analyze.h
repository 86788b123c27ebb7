// Mesh and camera in, everything sightline knows about the view out: the stages, one after the other.
//
// Source: docs/design.md, section 2. Errors: InternalError; in float and double ArithmeticError instead.
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/culling.h"
#include "geometry/projection/projected_scene.h"
#include "reconstruct/labelling/labelled_mesh.h"
#include "reconstruct/polygons/visible_polygons.h"
#include "reflect/reflections.h"
#include "reflect/triangles/reflecting_triangles.h"
#include "sweep/engine.h"
#include "sweep/segments/visible_segments.h"

namespace sightline {

struct View {
  ProjectedScene scene;
  VisibleSegments segments;
  VisiblePolygons polygons;
  LabelledMesh labelled;
  Reflections reflections;
};

// The mesh's facets do not pass through each other: cut_along_common_lines sees to that.
[[nodiscard]] inline View analyze(const Mesh& mesh, const Camera& camera, Sides sides = Sides::both,
                                  SweepObserver* observer = nullptr, const Precision& precision = {},
                                  Engine engine = Engine::fast) {
  View view;
  view.scene = project(mesh, camera, sides, precision);
  view.segments = find_visible_segments(mesh, view.scene, engine, observer);
  view.polygons = reconstruct_polygons(mesh, view.scene, view.segments);
  view.labelled = label_mesh(mesh, view.scene, view.segments, view.polygons);
  return view;
}

// With panels: world.surface is the mesh.
[[nodiscard]] inline View analyze(const MirrorWorld& world, const Camera& camera, Sides sides = Sides::both,
                                  const Precision& precision = {}) {
  const Mesh& mesh = *world.surface;
  View view;
  view.scene = project(mesh, camera, sides, precision);
  view.segments = find_visible_segments(mesh, view.scene);
  view.polygons = reconstruct_polygons(mesh, view.scene, view.segments);
  if (world.options.mode == ReflectionMode::triangles) {
    view.labelled = label_mesh(mesh, view.scene, view.segments, view.polygons);
    view.reflections = reflecting_triangles(world, camera, view.labelled);
    return view;
  }
  ReflectedView reflected = find_reflections(world, view.scene, view.segments, view.polygons);
  view.scene = std::move(reflected.scene);
  view.segments = std::move(reflected.segments);
  view.reflections = std::move(reflected.reflections);
  view.labelled = label_mesh(mesh, view.scene, view.segments, view.polygons, panel_borders(view.reflections));
  return view;
}

}  // namespace sightline
