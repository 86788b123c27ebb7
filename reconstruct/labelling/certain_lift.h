// From the image back to the surface where nothing was rounded, by numbers with bounds.
//
// In:  a point of the image; an edge of the mesh, or the plane of a facet, on which it lies.
// Out: the same bits as exactly (exact_lift.h); nothing where the bounds leave them open, or where the point is of a kind that
//      is not told in space here.
// Method: where the plane that an edge of the image is seen as meets the edge of the mesh (seen_in_space.h); where the ray to a
//      point that is seen there meets the facet's plane.
// Complexity: O(1), in doubles.
// Source: Koucky 2014, 3.8 and figure 3.8: the ray and the plane.
#pragma once

#include <optional>

#include "sweep/segments/image_points.h"
#include "sweep/segments/seen_in_space.h"

namespace sightline::inline reconstruct {

class CertainLift {
 public:
  explicit CertainLift(const ImagePoints& points)  // outlives it
      : points_(points), mesh_(points.scene().mesh()), space_(points.scene(), points.segments().swap_edges) {}

  // Precondition: the point is on the image of the edge's line.
  [[nodiscard]] std::optional<Point3> to_edge(MeshEdgeId edge, PointId p) const;
  // Precondition: the facet is not edge-on.
  [[nodiscard]] std::optional<Point3> to_plane(FacetId facet, PointId p) const;

 private:
  const ImagePoints& points_;
  const CutMesh& mesh_;
  SeenInSpace space_;
};

}  // namespace sightline::inline reconstruct
