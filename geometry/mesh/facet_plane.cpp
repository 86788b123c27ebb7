#include "geometry/mesh/facet_plane.h"

namespace sightline::inline geometry {

std::array<VertexId, 3> plane_corners(const PolygonMesh& mesh, std::span<const VertexId> corners) {
  std::size_t third = 2;
  if (corners.size() == 3) return {corners[0], corners[1], corners[2]};
  while (third + 1 < corners.size() &&
         collinear(mesh.position(corners[0]), mesh.position(corners[1]), mesh.position(corners[third]))) {
    ++third;
  }
  return {corners[0], corners[1], corners[third]};
}

std::array<VertexId, 3> plane_corners(const CutMesh& mesh, FacetId facet) {
  return plane_corners(mesh, mesh.uncut_corners(mesh.uncut_facet(facet)));
}

std::array<VertexId, 3> depth_plane_corners(const CutMesh& mesh, FacetId facet) {
  return plane_corners(mesh, mesh.uncut_corners(mesh.plane_of(mesh.uncut_facet(facet))));
}

Sign side_of_plane(const CutMesh& mesh, FacetId facet, const HomogeneousPoint& p) {
  const auto [a, b, c] = plane_corners(mesh, facet);
  return orient3d(mesh.position(a), mesh.position(b), mesh.position(c), p);
}

}  // namespace sightline::inline geometry
