// The plane of a facet, as three of its corners.
#pragma once

#include <array>

#include "geometry/mesh.h"
#include "geometry/predicates.h"

namespace sightline {

// Three corners that are not on one line, in the facet's orientation; a facet is convex and not degenerate, so they
// exist.
[[nodiscard]] std::array<VertexId, 3> plane_corners(const Mesh& mesh, FacetId facet);

// The side of the facet's plane on which p lies: +1 where the facet is counter-clockwise seen from p.
[[nodiscard]] Sign side_of_plane(const Mesh& mesh, FacetId facet, const HomogeneousPoint& p);

// The surface a facet belongs to: all of its face where that is planar, else the facet alone; named by its first facet.
// What is visible of one surface is described by polygons of its own.
[[nodiscard]] inline FacetId surface_of(const Mesh& mesh, FacetId facet) {
  if (!facet.valid()) return facet;
  const FaceId face = mesh.facet_face[facet.index()];
  return mesh.face_planar[face.index()] != 0 ? FacetId(mesh.first_facet(face)) : facet;
}

}  // namespace sightline
