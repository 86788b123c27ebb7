// The surface: vertices, faces as the input gives them, and the facets and edges derived from them.
//
// In:  positions, and per face the indices of its corners (build_mesh).
// Out: a Mesh, and a list of the faces that are no faces (FaceDefect); those stay in the numbering but have no facet.
// Holds (validate(mesh) checks it):
//   - facets of one face are consecutive, cover the face, and keep its orientation;
//   - a facet is convex, exactly planar and not degenerate: the whole face where that is all of this, else a triangle;
//   - a mesh edge joins two distinct positions; ends that are equal in position are one end (seams are welded for
//     topology only: vertices keep their indices and coordinates);
//   - faces, facets, corners are in file order.
// Complexity: O(n log n) in the number of corners, except the triangulation of concave faces: O(k^2) in their corners.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/numbers/export.h"
#include "geometry/numbers/ids.h"
#include "geometry/numbers/vector3.h"

namespace sightline::inline geometry {

// Polygons are index lists: face f has the corners corners[begin[f]] .. corners[begin[f + 1] - 1].
struct PolygonList {
  std::vector<std::uint32_t> begin{0};
  std::vector<VertexId> corners;

  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
  [[nodiscard]] std::span<const VertexId> operator[](std::size_t i) const {
    return std::span(corners).subspan(begin[i], begin[i + 1] - begin[i]);
  }
  void push_back(std::span<const VertexId> polygon) {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

// A defect says why a face is skipped, or what was mended. A reason that is not listed here does not exist.
enum class Defect : std::uint8_t {
  too_few_corners,  // fewer than three distinct corners: skipped
  zero_area,        // all corners on one line, exactly, or nothing but spikes: skipped
  self_crossing,    // its boundary crosses or overlaps itself in the same direction: skipped
  repeated_face,    // the same corners (by position) as an earlier face, in the same direction: skipped
  repeated_corner,  // consecutive equal corners, or a spike that turns straight back: removed, the rest is kept
};
[[nodiscard]] SIGHTLINE_EXPORT const char* to_string(Defect defect);
[[nodiscard]] SIGHTLINE_EXPORT bool is_skipped(Defect defect);

struct FaceDefect {
  FaceId face;
  Defect defect;
};

// A mesh has this in common with one whose facets were cut (cut_mesh.h): polygons, and their topology.
struct PolygonMesh {
  std::vector<Point3> vertices;
  PolygonList faces;                      // as the input gives them, defects included
  PolygonList facets;                     // corner indices are those of the input; see shared_corners.h, too
  std::vector<FaceId> facet_face;         // per facet
  std::vector<FacetId> face_facet;        // per face, and one past the end: its first facet
  std::vector<std::uint8_t> face_planar;  // per face: 1 where all its corners lie in one plane, exactly

  // The topology has equal positions welded.
  std::vector<VertexId> weld;  // per vertex: the first vertex with this position
  // Each mesh edge has its ends (welded), the lexicographically smaller position first.
  std::vector<std::array<VertexId, 2>> edges;
  std::vector<MeshEdgeId> facet_edges;  // parallel to facets.corners: the edge from this corner to the next

  std::vector<FaceDefect> defects;

  [[nodiscard]] std::size_t face_count() const { return faces.size(); }
  [[nodiscard]] std::size_t facet_count() const { return facets.size(); }
  [[nodiscard]] std::span<const VertexId> corners(FacetId f) const { return facets[f.index()]; }
  [[nodiscard]] std::span<const MeshEdgeId> edges_of(FacetId f) const {
    const auto first = facets.begin[f.index()];
    return std::span(facet_edges).subspan(first, facets.begin[f.index() + 1] - first);
  }
  [[nodiscard]] const Point3& position(VertexId v) const { return vertices[v.index()]; }
  [[nodiscard]] std::size_t first_facet(FaceId f) const { return face_facet[f.index()].index(); }
  [[nodiscard]] std::size_t end_facet(FaceId f) const { return face_facet[f.index() + 1].index(); }
};

// A surface as it is given: its facets may pass through each other, so it cannot be swept (cut_mesh.h).
struct Mesh : PolygonMesh {};

// Throws std::invalid_argument if a corner names no vertex or a coordinate is not finite (readers check this first,
// with file and line).
[[nodiscard]] SIGHTLINE_EXPORT Mesh build_mesh(std::vector<Point3> vertices, PolygonList faces);

// Returns what of the above does not hold, one line each, with the ids; empty for a valid mesh.
[[nodiscard]] SIGHTLINE_EXPORT std::vector<std::string> validate(const Mesh& mesh);

}  // namespace sightline::inline geometry
