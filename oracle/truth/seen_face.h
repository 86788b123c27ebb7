// The faces as the camera sees them, exactly: their outlines in the window, and their nearness over it.
//
// In:  mesh, camera, sides. Out: per planar face, or facet of a face that is not planar, what is in the view volume;
// those that are skipped, edge-on, culled or out of view are left out. In the order of face and facet.
// Holds: all w > 0. |X| <= W and |Y| <= W leave only the eye at W = 0, and a face through the eye is edge-on.
#pragma once

#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/projected_scene.h"
#include "oracle/truth/outline.h"

namespace sightline::oracle::image {

// The plane is a x + b y + n * nearness + d = 0, with n > 0.
struct Plane {
  Integer a;
  Integer b;
  Integer n;
  Integer d;
};

struct SeenFace {
  FaceId face;
  Plane plane;
  Outline outline;       // counter-clockwise
  bool is_front = true;  // the eye sees its front
};

// planes: per facet the one whose plane it has its depths in, or nothing: each has its own.
[[nodiscard]] std::vector<SeenFace> seen_faces(const PolygonMesh& mesh, const Camera& camera, Sides sides,
                                               const std::vector<FacetId>& planes = {});

// Returns the line of equal depth, p being nearer on its inner side; zero where they are one plane.
[[nodiscard]] Line where_nearer(const Plane& p, const Plane& q);

}  // namespace sightline::oracle::image
