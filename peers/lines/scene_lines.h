// The scene as lines: the mesh edges that bound what the camera may see, in the window, with their depth.
//
// In:  a flat scene.
// Out: one line per mesh edge of the scene's polygons, as far as it is in the window: common lines, along which the
//      mesh was cut, are such edges. By mesh edge.
// Holds: an end that is a vertex inside the window has the vertex' grid point, so that lines through it meet there;
//      depth is affine along a line. Not there: edges seen end-on, and edges along the window's border.
// A line that crosses the eye's plane is first cut before it, where it has left a window of twice the size for good;
// then every line is clipped to the window by Cohen-Sutherland, whose new ends are rounded to the grid as those of
// the polygons are.
// Not looked at: the camera's near and far bounds.
// Complexity: O(n log n). Errors: none.
#pragma once

#include <vector>

#include "geometry/numbers/predicates.h"
#include "peers/lines/window.h"
#include "peers/scene/flat_scene.h"

namespace sightline::peers {

struct LineEnd {
  Corner place;
  VertexId vertex;  // welded; invalid: the line ends on the window's border
};

struct SceneLine {
  MeshEdgeId edge;  // from its first end to its second
  LineEnd from;
  LineEnd to;
  FacetId left;     // of the polygons on the line, the nearest one just left of it in the image; invalid: none
  FacetId right;    // and just right of it
  int winding = 0;  // how many of them lie to its left, less those to its right

  [[nodiscard]] Corner at(double t) const;
};

[[nodiscard]] std::vector<SceneLine> scene_lines(const FlatScene& scene);

// Returns whether the line parts two surfaces: false inside a planar face that was cut into several polygons.
[[nodiscard]] bool parts_surfaces(const CutMesh& mesh, const SceneLine& line);

// Lines whose visibility is asked for are thought moved by an infinitesimal step to the right, and infinitely less
// upwards. Whatever lies on them in the image, vertices and other edges, is then to one side of them, always the same
// one: nothing is counted twice or not at all. The sides are exact on the coordinates given (Edelsbrunner and Mücke
// 1990, Simulation of Simplicity).
//
// Returns the side of the line from a to b on which p lies when it is moved by the step: +1 to the left, -1 to the
// right.
[[nodiscard]] inline Sign side_of_moved_point(const Point2& a, const Point2& b, const Point2& p) {
  const Sign side = orient2d(a, b, p);
  if (side != 0) return side;
  if (a.y != b.y) return b.y > a.y ? -1 : 1;
  return b.x > a.x ? 1 : -1;
}

// Returns the side on which p lies when the line is moved by the step.
[[nodiscard]] inline Sign side_of_moved_line(const Point2& a, const Point2& b, const Point2& p) {
  const Sign side = orient2d(a, b, p);
  return side != 0 ? side : -side_of_moved_point(a, b, p);
}

}  // namespace sightline::peers
