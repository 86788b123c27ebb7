// Views for tests: of meshes that are taken as they are, whatever passes through what, with given sides.
#pragma once

#include "sightline/analyzer.h"

namespace sightline::tests {

// A mesh, cut or not, that a test sweeps as it is.
class AnyMesh {
 public:
  AnyMesh(Mesh mesh) : mesh_(uncrossed(std::move(mesh))) {}
  AnyMesh(CutMesh mesh) : mesh_(std::move(mesh)) {}
  operator const CutMesh&() const { return mesh_; }
  [[nodiscard]] const CutMesh& operator*() const { return mesh_; }
  [[nodiscard]] const CutMesh* operator->() const { return &mesh_; }

 private:
  CutMesh mesh_;
};

inline View analyzed(const AnyMesh& mesh, const Camera& camera, Sides sides = Sides::both,
                     const Precision& precision = {}) {
  return Analyzer(*mesh, {.sides = policy_of(sides), .precision = precision}).view(camera);
}

inline ProjectedScene project(const AnyMesh& mesh, const Camera& camera, Sides sides, const Precision& precision = {}) {
  return sightline::project(*mesh, camera, sides, precision);
}

// The panels of the world are reflected.
inline View analyzed(const MirrorWorld& world, const Camera& camera, const Precision& precision = {}) {
  return Analyzer(world.surface, {.sides = SidesPolicy::both, .precision = precision, .reflection = world.options})
      .view(camera, world);
}

inline MirrorWorld mirror_world(const AnyMesh& mesh, std::vector<Panel> panels, const ReflectionOptions& options = {},
                                const std::vector<Vector3>& given_normals = {}) {
  return make_mirror_world(std::make_shared<const CutMesh>(*mesh), std::move(panels), options, given_normals);
}

}  // namespace sightline::tests
