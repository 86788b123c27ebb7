// Vertex normals: which way the surface that a mesh stands for faces at its corners.
//
// In:  a mesh, and what its file gives: a vector per corner (parallel to mesh.faces.corners), of any length, zero where there is
//      none; or nothing at all. How means are made of what is not given.
// Out: a unit vector per corner: what is given, else the mean of the normals of the faces that meet at the corner's
//      position. Zero where that mean is zero, and where all those faces are skipped.
// Means are plain (Koucky 2014, 3.2), or weighted by the faces' areas; and beyond a crease the faces do not count: those whose
//      normals turn by more than an angle from that of the corner's own face.
// Floating point: normals are a model of a smooth surface, not a property of the mesh.
// Complexity: O(n); with a crease O(n k) for k faces around a vertex.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace sightline::inline geometry {

enum class NormalMeans : std::uint8_t { area, plain };
[[nodiscard]] SIGHTLINE_EXPORT const char* to_string(NormalMeans means);

struct NormalOptions {
  NormalMeans means = NormalMeans::area;
  std::optional<double> crease_angle_degrees = std::nullopt;
};

[[nodiscard]] SIGHTLINE_EXPORT std::vector<Vector3> vertex_normals(const PolygonMesh& mesh,
                                                                   const std::vector<Vector3>& given,
                                                                   const NormalOptions& options = {});

// What makes normals other than their owner may think.
struct NormalDoubts {
  // Where normals are given, they all are those of their faces, but for a tenth of a degree, though faces meet at larger angles: the
  // surface is as flat as its faces.
  bool are_of_faces = false;
  // The corners whose given normal points to the back of their face, and the first such face.
  std::size_t turned_corners = 0;
  FaceId first_turned;
  // Of neighbours whose normals have a mean across the edge between them: the largest angle, in degrees, and the two faces.
  double sharpest_mean = 0;
  std::array<FaceId, 2> sharpest;
};

[[nodiscard]] SIGHTLINE_EXPORT NormalDoubts doubts_about_normals(const PolygonMesh& mesh,
                                                                 const std::vector<Vector3>& given,
                                                                 const NormalOptions& options = {});

}  // namespace sightline::inline geometry
