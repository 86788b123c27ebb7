// From the image back to the surface where nothing was rounded: the exact point, rounded once.
//
// In:  an exact place of the image; an edge of the mesh, or a facet, on which it lies.
// Out: the point of the edge (of the facet's plane) that is seen there, in input coordinates: each coordinate is the double
//      nearest to the true one. So the same point lifted along different edges and planes has the same bits.
// Method: a place (x, y, w) is a sum of those of the corners, each times a number m; these are determinants of three places.
//      With a corner's position (px, py, pz) over its factor `one`, as its place is, the point is the sum of the positions
//      times m over the sum of the factors times m (clipping.h).
// Complexity: O(1), in integers of any size.
// Source: Koucky 2014, 3.8 and figure 3.8, with the ray and the plane as determinants.
#pragma once

#include <array>

#include "geometry/projection/projected_scene.h"

namespace sightline::inline reconstruct {

// Lifts to one edge after another. Not for several threads at once.
class EdgeLift {
 public:
  explicit EdgeLift(const ProjectedScene& scene) : mesh_(scene.mesh()), exact_corners_(scene.camera) {}

  // Precondition: the place is on the image of the edge's line.
  [[nodiscard]] Point3 operator()(MeshEdgeId edge, const ExactPlace& place);

 private:
  const CutMesh& mesh_;
  ExactCorners exact_corners_;
};

// Lifts to one plane after another. Not for several threads at once.
class PlaneLift {
 public:
  explicit PlaneLift(const ProjectedScene& scene) : mesh_(scene.mesh()), exact_corners_(scene.camera) {}

  // The plane is that of a facet, which is not edge-on.
  void begin(FacetId facet);
  [[nodiscard]] Point3 operator()(const ExactPlace& place);

 private:
  const CutMesh& mesh_;
  ExactCorners exact_corners_;
  FacetId facet_;
  FacetId of_corners_;  // invalid: no corners are known
  std::array<ExactCorner, 3> corners_;
};

}  // namespace sightline::inline reconstruct
