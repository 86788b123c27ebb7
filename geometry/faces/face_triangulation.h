// Triangles for a face that is not planar or not convex.
//
// In:  a polygon without spikes (see remove_spikes), whose corners are not all on one line. It may touch itself,
//      and run along a line once in each direction: holes joined by bridge edges are such polygons.
// Out: triangles with the polygon's orientation, each with an area greater than zero, that together cover the polygon
//      once; nullopt if there are none, because its boundary crosses itself or goes round some place twice.
// Holds: k corners give k - 2 triangles, less two for each place where clipping leaves a spike (a polygon whose parts
//      hang together in one point). Every corner is used, those inside a straight run too.
//
// The polygon is divided as it appears when seen along its Newell normal. That is exact, then rounded to a direction in
// doubles; all decisions are exact for that direction, and for a planar polygon they are the same for all. Where a
// non-planar polygon runs over itself in this view, views tilted by an infinitesimal towards +x, -x, +y, -y, +z, -z
// follow. Ears are clipped, that with the highest vertex index first: a convex quad is split by the diagonal that
// misses its highest vertex. The rule depends on vertex indices and positions only: not on the first corner, nor on
// the direction, nor on other faces, and (but for tilted views) a mirrored scene gives mirrored triangles.
//
// Complexity: O(k^2) exact predicates.
// Source: ear clipping after G. H. Meisters, Polygons have ears (1975); exact, and for polygons that touch themselves.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/faces/face_shape.h"

namespace sightline::inline geometry {

using Triangle = std::array<VertexId, 3>;

[[nodiscard]] std::optional<std::vector<Triangle>> triangulate(const PolygonView& polygon);

// A view says how a face is looked at to divide it: in parallel projection against `normal`, tilted by an infinitesimal
// towards `tilt`, and by an infinitesimal of that towards `second_tilt` (zero vectors for no tilt).
struct FaceView {
  Vector3 normal = Vector3::Zero();
  Vector3 tilt = Vector3::Zero();
  Vector3 second_tilt = Vector3::Zero();

  // Returns +1 where a, b, c turn left. For points on a line it is 0 in all views.
  [[nodiscard]] Sign turn(const Point3& a, const Point3& b, const Point3& c) const;
};

// Returns the views that a polygon can be divided in, as above: in each it runs counter-clockwise. There is none if its
// Newell normal is zero.
[[nodiscard]] std::vector<FaceView> face_views(const PolygonView& polygon);

// Returns whether no two of these triangles, all counter-clockwise in the view, share an inner point.
[[nodiscard]] bool interiors_disjoint(const FaceView& view, std::span<const Triangle> triangles,
                                      std::span<const Point3> vertices);

}  // namespace sightline::inline geometry
