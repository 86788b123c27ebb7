// Vertex normals: which way the surface that a mesh stands for faces at its corners.
//
// In:  a mesh, and what its file gives: a vector per corner (parallel to mesh.faces.corners), zero where there is none;
//      or nothing at all.
// Out: a unit vector per corner: what is given, else the mean of the normals of the faces that meet at the corner's
//      position, weighted by their areas. Zero where that mean is zero, and where all those faces are skipped.
// Floating point: normals are a model of a smooth surface, not a property of the mesh.
// Complexity: O(n).
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace sightline::inline geometry {

[[nodiscard]] std::vector<Vector3> vertex_normals(const PolygonMesh& mesh, const std::vector<Vector3>& given);

}  // namespace sightline::inline geometry
