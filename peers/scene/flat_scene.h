// The scene as the textbooks' algorithms begin with it: flat convex polygons of the image, each with its depth.
//
// In:  a mesh cut along common lines, and its projected scene (which culled, clipped and projected).
// Out: one polygon per facet in view, by facet. x and y are in the window [-1, 1]^2, x to the right, y up. Depth grows
//      away from the eye and is affine over the image of a plane, so that flat polygons stay flat and the eye may be
//      thought infinitely far away at depth minus infinity (the normalized view volume): -1 / W where the camera is a
//      pinhole, the distance along the view direction where it is orthographic.
// Holds: corners are counter-clockwise in the image, whichever side of the facet is seen; polygons are by facet; no
//      polygon passes through another one. Everything is double: x and y are the grid's points, exactly; the plane is
//      computed from the input's coordinates and rounded, corners' depths are the plane's there. Planes are finite:
//      facets seen so nearly edge-on that double arithmetic finds the eye in their plane are left out. Polygons are
//      convex but for the rounding to the grid: that may dent one by less than a cell, and turn an edge as short as a
//      cell into any direction.
// Complexity: O(n). Errors: none.
// Source: slides 001 and 004 (polygons with plane equations z = -(A x + B y + D) / C).
// Departure: facets instead of faces (a concave face is several), pieces instead of facets that pass through each
// other: the algorithms differ in what they do with polygons, not in how they get them.
#pragma once

#include <vector>

#include "geometry/projection/projected_scene.h"

namespace sightline::peers {

struct Corner {
  double x = 0;
  double y = 0;
  double depth = 0;
};

// depth = a x + b y + c is the slides' plane equation, solved for the depth.
struct DepthPlane {
  double a = 0;
  double b = 0;
  double c = 0;
  [[nodiscard]] double at(double x, double y) const { return (a * x + b * y) + c; }
};

// These are the smallest and largest x, y and depth of the corners: the slides' extents.
struct Extent {
  Corner least;
  Corner most;
};

struct FlatPolygon {
  FaceId face;
  FacetId facet;
  bool is_front = true;  // the eye sees the facet's front side
  DepthPlane plane;
  std::vector<Corner> corners;
};

struct FlatScene {
  const CutMesh* mesh = nullptr;
  const ProjectedScene* projected = nullptr;
  std::vector<FlatPolygon> polygons;
};

// The mesh and the projected scene must live as long as the result is used.
[[nodiscard]] FlatScene flat_scene(const ProjectedScene& scene);

// Returns whether a is in front of b where both lie in one plane: the one that looks at the eye is in front of one that
// is turned away, and of two alike the lower face.
[[nodiscard]] bool is_in_front_in_plane(const FlatPolygon& a, const FlatPolygon& b);

[[nodiscard]] Extent extent_of(const std::vector<Corner>& corners);

}  // namespace sightline::peers
