// From the image back to the surface.
//
// In:  a point of the image that lies on a facet (on one of its edges), in the facet's rounded polygon.
// Out: the point of the facet (of the edge) in input coordinates. The rounded image polygon and the facet are related
//      by the projective map that takes corner to corner; so a point of the one lifts to a point of the other, never
//      outside, and a point on an edge is computed from that edge's ends alone: both neighbours get the same bits.
//      The barycentric coordinates are exact fractions, rounded once; the combination of the corners rounds a few
//      times more.
// Source: Koucky 2014, 3.8 and figure 3.8, with the ray replaced by the projective map.
#pragma once

#include <optional>

#include "geometry/projection/projected_scene.h"
#include "sweep/segments/image_points.h"

namespace sightline::inline reconstruct {

// p lies strictly between the images of a and b, on the edge that joins them. Which of its ends is a matters for the
// last bits: the mesh edge says it, not the face.
[[nodiscard]] Point3 lift_on_edge(const ProjectedScene& scene, const ImagePoints& points, const ClippedCorner& a,
                                  const ClippedCorner& b, PointId p);

// The result is empty where p is not in the facet's rounded polygon.
[[nodiscard]] std::optional<Point3> lift_on_facet(const ProjectedScene& scene, const ImagePoints& points, FacetId facet,
                                                  PointId p);

}  // namespace sightline::inline reconstruct
