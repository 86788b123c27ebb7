#include "reflect/world/wholes.h"

#include "geometry/mesh/facet_plane.h"
#include "reflect/world/obstacles.h"

namespace sightline::inline reflect {

CutPolygon whole_polygon(const Mesh& mesh, WholeId whole) {
  CutPolygon polygon;
  for (const VertexId v : whole_corners(mesh, whole)) polygon.push_back({exact_position(mesh.position(v)), v, {}});
  return polygon;
}

std::array<Point3, 3> plane_points(const Mesh& mesh, FacetId facet) {
  const auto [a, b, c] = plane_corners(mesh, facet);
  return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

ExactPlane plane_through(const std::array<Point3, 3>& points) {
  return plane_through(exact_position(points[0]), exact_position(points[1]), exact_position(points[2]));
}

}  // namespace sightline::inline reflect
