#include "reflect/world/uncut_facets.h"

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline reflect {

Box box_of(const CutMesh& mesh, std::span<const VertexId> corners) {
  Box box{mesh.position(corners.front()), mesh.position(corners.front())};
  for (const VertexId v : corners) box = hull(box, {mesh.position(v), mesh.position(v)});
  return box;
}

CutPolygon uncut_polygon(const CutMesh& mesh, UncutFacetId uncut) {
  CutPolygon polygon;
  for (const VertexId v : mesh.uncut_corners(uncut)) polygon.push_back({exact_position(mesh.position(v)), v, {}});
  return polygon;
}

std::array<Point3, 3> plane_points(const CutMesh& mesh, FacetId facet) {
  const auto [a, b, c] = plane_corners(mesh, facet);
  return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

ExactPlane plane_through(const std::array<Point3, 3>& points) {
  return plane_through(exact_position(points[0]), exact_position(points[1]), exact_position(points[2]));
}

std::vector<std::array<VertexId, 3>> fans_of(const CutMesh& mesh, FacetId surface) {
  std::vector<std::array<VertexId, 3>> triangles;
  UncutFacetId last;
  for (std::size_t f = surface.index(); f < end_of_surface(mesh, surface).index(); ++f) {
    const UncutFacetId uncut = mesh.uncut_facet(FacetId(f));
    if (uncut == last) continue;
    last = uncut;
    const auto corners = mesh.uncut_corners(uncut);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
  return triangles;
}

}  // namespace sightline::inline reflect
