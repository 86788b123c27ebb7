// Faces that lie on each other, or all but.
//
// What is written in decimals is rounded: a window in its wall, coplanar by design, is in front of it here and behind it there by
// the last digit of a corner, and what is seen of either is noise. This finds such pairs, so that somebody can be told.
//
// In:  convex polygons, or the faces of a mesh, and a distance.
// Out: the pairs that overlap, seen across, and are nowhere in their overlap further apart than the distance. An overlap is one that
//      holds a circle, the radius of which is `least_overlap` distances: what is narrower, as where two faces meet in an edge,
//      is none. Faces with the same corners, one of them turned, are a pair by design, and not listed as faces.
// Approximate: computed in double, a few roundings of the coordinates' size; nothing that is decided behind the door rests on it.
// Complexity: O(n log n) and the pairs whose boxes come closer than the distance.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/export.h"

namespace sightline::inline geometry {

constexpr double least_overlap = 1000;

struct Coincidence {
  double distance = 0;  // the largest in the overlap, 0 where both are in one plane
  double overlap = 0;   // its area
};

struct FacetCoincidence : Coincidence {
  FacetId first;  // the lower index
  FacetId second;
};

struct FaceCoincidence : Coincidence {
  FaceId first;  // the lower index
  FaceId second;
  bool is_snapped = false;  // both count as coplanar (CutMesh::snapped_to)
};

// The polygons are convex and planar, in either orientation.
[[nodiscard]] std::optional<Coincidence> coincidence_of(std::span<const Point3> a, std::span<const Point3> b,
                                                        double distance);

// Returns the faces that come as close to a point as the distance, in order. Complexity: O(n).
[[nodiscard]] SIGHTLINE_EXPORT std::vector<FaceId> faces_at(const PolygonMesh& mesh, const Point3& point,
                                                            double distance);

// The pairs are sorted.
[[nodiscard]] SIGHTLINE_EXPORT std::vector<FaceCoincidence> find_coincidences(const CutMesh& mesh, double distance);

// The same of facets of different faces, in the order in which they are found; those with the same corners are pairs, too.
[[nodiscard]] std::vector<FacetCoincidence> coincident_facets(const PolygonMesh& mesh, double distance);

// Returns the length of the diagonal of the box around all faces: the scene's size.
[[nodiscard]] SIGHTLINE_EXPORT double size_of(const PolygonMesh& mesh);

}  // namespace sightline::inline geometry
