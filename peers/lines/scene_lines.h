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
[[nodiscard]] bool parts_surfaces(const Mesh& mesh, const SceneLine& line);

}  // namespace sightline::peers
