// A mirror view is what a camera sees in a flat mirror, exactly.
//
// The mirror camera (Koucky's C_r) is the camera's mirror image in the mirror's plane. What it sees through the mirror
// is what the camera sees in it, at the same places of the image: the mirror's own points are their own mirror images.
// So a point of space has the image that the camera gives its mirror image. No mirror image is computed: the camera's
// linear forms, composed with the reflection, are forms on the points themselves, with integer coefficients.
//
// In:  the camera, and a plane that has its eye strictly in front.
// Out: images of convex polygons: of what lies in front of the mirror and is seen in the window, rounded once to the
//      grid like every image point. Convex but for that rounding; empty where there is none.
// Complexity: O(k) integer operations for k corners.
// Source: Koucky 2014, 3.9, figure 3.9.
#pragma once

#include <array>
#include <vector>

#include "geometry/cutting/facet_cutter.h"
#include "geometry/projection/camera.h"
#include "reflect/regions/sheets.h"

namespace sightline::inline reflect {

class MirrorView {
 public:
  MirrorView(const Camera& camera, const ExactPlane& mirror, int grid_bits);

  // Returns on which side of a plane the mirror camera's centre is (for an orthographic camera: its direction to the
  // viewer).
  [[nodiscard]] Sign side_of_centre(const ExactPlane& plane) const;

  [[nodiscard]] ImagePolygon image(CutPolygon polygon) const;

 private:
  ExactPlane mirror_;
  ExactPosition centre_;  // its w is 0 for a direction
  ExactPlane x_, y_, w_;  // up to one positive factor, the homogeneous image of a point of space
  std::array<ExactPlane, 4> bounds_;
  int grid_bits_;
};

// Returns the polygon without corners that are those before them; it is empty where fewer than three are left.
[[nodiscard]] ImagePolygon distinct_corners(const ImagePolygon& corners);

// Returns the camera's eye as an exact position; w = 0 for a direction.
[[nodiscard]] ExactPosition exact_eye(const Camera& camera);

}  // namespace sightline::inline reflect
