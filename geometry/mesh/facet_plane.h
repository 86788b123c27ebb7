// The plane of a facet is given as three vertices of the input.
#pragma once

#include <array>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/predicates.h"

namespace sightline::inline geometry {

// Three corners of a convex polygon that are not on one line, the first of all, in its orientation.
[[nodiscard]] std::array<VertexId, 3> plane_corners(const PolygonMesh& mesh, std::span<const VertexId> corners);

// Returns three corners of the facet (where it was cut: of the uncut facet it is a piece of) that are not on one line, in its
// orientation; a facet is convex and not degenerate, so they exist.
[[nodiscard]] std::array<VertexId, 3> plane_corners(const CutMesh& mesh, FacetId facet);

// The same of the plane that is the facet's in the order of depth (CutMesh::snapped_to), in the orientation of whose it is.
[[nodiscard]] std::array<VertexId, 3> depth_plane_corners(const CutMesh& mesh, FacetId facet);

// Returns the side of the facet's plane on which p lies: +1 where the facet is counter-clockwise seen from p.
[[nodiscard]] Sign side_of_plane(const CutMesh& mesh, FacetId facet, const HomogeneousPoint& p);

// Returns the surface a facet belongs to, named by its first facet: all of its face where that is planar, else the
// uncut facet it was cut from, else the facet alone. What is visible of one surface is described by polygons of its own.
[[nodiscard]] inline FacetId surface_of(const CutMesh& mesh, FacetId facet) {
  if (!facet.valid()) return facet;
  const FaceId face = mesh.facet_face[facet.index()];
  if (mesh.face_planar[face.index()] != 0) return FacetId(mesh.first_facet(face));
  return mesh.first_piece(mesh.uncut_facet(facet));
}

// Returns one past the last facet of a surface, which is named by its first facet.
[[nodiscard]] inline FacetId end_of_surface(const CutMesh& mesh, FacetId surface) {
  const FaceId face = mesh.facet_face[surface.index()];
  if (mesh.face_planar[face.index()] != 0) return FacetId(mesh.end_facet(face));
  return mesh.end_piece(mesh.uncut_facet(surface));
}

}  // namespace sightline::inline geometry
