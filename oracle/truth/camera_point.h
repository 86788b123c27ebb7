// The input is taken to the camera's homogeneous coordinates, exactly.
//
// With one unit for all input coordinates and one for the camera's rows, both powers of two, everything becomes whole
// numbers over a common factor: a vertex v is (X, Y, N, W), with X, Y, W as in camera.h. N / W is its nearness,
// the larger the nearer: 1 / W of the camera for a pinhole, minus the depth for an orthographic camera. Over a plane it
// is an affine function of the place in the image.
#pragma once

#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "oracle/truth/image.h"

namespace sightline::oracle::image {

struct CameraPoint {
  Point place;  // (X, Y, W)
  Integer nearness;
};

struct WholeVector {
  Integer x;
  Integer y;
  Integer z;
};

struct ExactCamera {
  bool perspective = true;
  int unit = 0;  // input coordinates are multiples of 2^unit
  WholeVector right;
  WholeVector up;
  WholeVector forward;
  WholeVector origin;
  Integer one;         // 1 as a camera coordinate
  int handedness = 1;  // +1: what is counter-clockwise in space seen from the eye is so in the image
};

// Returns the camera for the vertices of a mesh.
[[nodiscard]] ExactCamera exact_camera(const PolygonMesh& mesh, const Camera& camera);

[[nodiscard]] CameraPoint camera_point(const ExactCamera& camera, const Point3& v);

}  // namespace sightline::oracle::image
