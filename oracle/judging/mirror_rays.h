// Reflections by rays, in plain floating point: the oracle of reflect/, with which it shares no code.
//
// In:  faces, panels and a pinhole camera. Out: which panel a ray through a place of the window meets after it was
//      mirrored once, if any; -1: none. With normals (parallel to mesh.faces.corners, of triangles, of any length) it is mirrored at
//      their interpolation, and what does not rise from its face meets nothing.
// Method: brute force. The ray's first hit on a face, the law of reflection at the face's plane, and of the mirrored
//      ray the first hit on another face or a panel.
#pragma once

#include <array>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "reflect/world/panel.h"

namespace sightline::lattice {

class MirrorRays {
 public:
  MirrorRays(const PolygonMesh& mesh, const std::vector<Panel>& panels, const Camera& camera,
             const std::vector<Vector3>& normals = {});

  // x and y are in the window [-1, 1]^2.
  [[nodiscard]] int panel_at(double x, double y) const;

 private:
  struct Target {
    std::array<Point3, 3> corners;
    Vector3 normal = Vector3::Zero();
    std::size_t owner = 0;  // the face, or the panel
    bool front_only = false;
    std::array<Vector3, 3> normals{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};  // at the corners
  };
  struct Hit {
    double distance = 0;
    const Target* target = nullptr;
  };

  [[nodiscard]] static Vector3 normal_at(const Target& target, const Point3& place);
  void add(std::vector<Target>& targets, const PolygonMesh& mesh, std::size_t owner, bool front_only) const;
  [[nodiscard]] static Hit first_hit(const std::vector<Target>& targets, const Point3& origin, const Vector3& direction,
                                     const Target* from);

  Camera camera_;
  bool is_bent_ = false;
  std::vector<Target> faces_;
  std::vector<Target> panels_;
};

}  // namespace sightline::lattice
