// From the image back to the surface where nothing was rounded: the exact point, rounded once.
//
// In:  a point of the image; an edge of the mesh, or a facet, on which it lies.
// Out: the point of the edge (of the facet's plane) that is seen there, in input coordinates: each coordinate is the double
//      nearest to the true one. So the same point lifted along different edges and planes has the same bits.
// Method: numbers with bounds, where they decide all bits (certain_lift.h). Else integers: a place (x, y, w) is a sum of those of
//      the corners, each times a number m; these are determinants of three places. With a corner's position (px, py, pz) over
//      its factor `one`, as its place is, the point is the sum of the positions times m over the sum of the factors times m
//      (clipping.h).
// Complexity: O(1), in integers of any size.
// Source: Koucky 2014, 3.8 and figure 3.8, with the ray and the plane as determinants.
#pragma once

#include <array>

#include "reconstruct/labelling/certain_lift.h"

namespace sightline::inline reconstruct {

// Lifts to one edge after another. Not for several threads at once.
class EdgeLift {
 public:
  explicit EdgeLift(const ImagePoints& points)
      : points_(points), certain_(points), exact_corners_(points.scene().camera) {}

  // Precondition: the point is on the image of the edge's line.
  [[nodiscard]] Point3 operator()(MeshEdgeId edge, PointId p);
  [[nodiscard]] Point3 exact(MeshEdgeId edge, PointId p);

 private:
  const ImagePoints& points_;
  const CertainLift certain_;
  ExactCorners exact_corners_;
};

// Lifts to one plane after another. Not for several threads at once.
class PlaneLift {
 public:
  explicit PlaneLift(const ImagePoints& points)
      : points_(points), certain_(points), exact_corners_(points.scene().camera) {}

  // The plane is that of a facet, which is not edge-on.
  void begin(FacetId facet) { facet_ = facet; }
  [[nodiscard]] Point3 operator()(PointId p);
  [[nodiscard]] Point3 exact(PointId p);

 private:
  const ImagePoints& points_;
  const CertainLift certain_;
  ExactCorners exact_corners_;
  FacetId facet_;
  FacetId of_corners_;  // invalid: no corners are known
  std::array<ExactCorner, 3> corners_;
};

}  // namespace sightline::inline reconstruct
