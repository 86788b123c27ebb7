// Which of two facets is in front where one of them counts as in the plane of another facet (CutMesh::snapped_to), exactly.
//
// In:  two facets that have depths in their planes before the eye, a ray on which both are seen.
// Out: +1 where the first is nearer on the ray, 0 where both are equally near.
// Method: the forms of nearness.h. On a ray in the direction (X, Y, W) of the camera's coordinates a plane is at the share k / (a X +
//      b Y + c W) of the way; both forms are positive, so the larger one is nearer. Of an image without perspective the place is
//      (X, Y, 1), and the forms are minus the depth.
// Complexity: O(1), in integers of any size: few facets are snapped.
#pragma once

#include "sweep/segments/nearness.h"

namespace sightline::inline sweep {

class SnappedOrder {
 public:
  explicit SnappedOrder(const ProjectedScene& scene) : scene_(scene), nearness_(scene), corners_(scene.camera) {}

  [[nodiscard]] Sign nearer_at(FacetId f, FacetId g, VertexId corner);
  // Precondition: a b and c d cross, seen from the eye.
  [[nodiscard]] Sign nearer_at_crossing(FacetId f, FacetId g, VertexId a, VertexId b, VertexId c, VertexId d);

 private:
  [[nodiscard]] ExactVector ray_to(VertexId corner);
  [[nodiscard]] Sign nearer_on(FacetId f, FacetId g, const ExactVector& ray);

  const ProjectedScene& scene_;
  ExactNearness nearness_;
  ExactCorners corners_;
};

}  // namespace sightline::inline sweep
