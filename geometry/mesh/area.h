// Areas in space are computed in double, as half the length of a cross product, in input units squared.
#pragma once

#include "geometry/mesh/mesh.h"

namespace sightline::inline geometry {

inline double triangle_area(const Point3& a, const Point3& b, const Point3& c) {
  return 0.5 * norm((b - a).cross(c - a));
}

// Returns the area of a convex polygon, as a fan from its first corner; `position(corner)` is the corner's place.
template <class Corners, class Position>
double fan_area(const Corners& corners, Position position) {
  double area = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    area += triangle_area(position(corners[0]), position(corners[i - 1]), position(corners[i]));
  }
  return area;
}

inline double facet_area(const PolygonMesh& mesh, FacetId facet) {
  return fan_area(mesh.corners(facet), [&](VertexId v) { return mesh.position(v); });
}

}  // namespace sightline::inline geometry
