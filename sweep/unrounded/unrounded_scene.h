// A projected scene whose points are not rounded.
//
// In:  a mesh, whose facets may pass through each other; a camera; which sides count.
// Out: the projected scene, in which corners have one point only where they fall on each other exactly; per point its place in
//      double with a proven radius, and, for whoever asks, exactly. The scene's own points are these places on the grid, for
//      those who only look; in the sweep order of the places, not of the grid.
// Holds: what holds for a projected scene, but for what is said of the grid.
// Complexity: O(n log n), and an exact place, in integers of any size, wherever two corners are not known to be apart.
// Source: docs/design.md, section 9. Precision as asked for in Precision (arithmetic.h) has no meaning here.
#pragma once

#include <memory>
#include <vector>

#include "geometry/projection/projected_scene.h"
#include "sweep/unrounded/exact_place.h"

namespace sightline::inline sweep {

class UnroundedScene {
 public:
  ProjectedScene scene;
  std::vector<CertifiedPlace> places;  // per point

  [[nodiscard]] const CutMesh& mesh() const { return scene.mesh(); }

  // Returns the exact place of a point. It is computed anew each time.
  [[nodiscard]] ExactPlace exact(PointId p) const;

 private:
  friend class UnroundedBuilder;

  // A point is that of a vertex, or of a corner that clipping made.
  struct Source {
    VertexId vertex;
    std::uint32_t made = 0;
  };
  std::vector<Source> sources_;  // per point
  std::vector<ExactPlace> made_;
};

[[nodiscard]] UnroundedScene project_unrounded(std::shared_ptr<const CutMesh> mesh, const Camera& camera, Sides sides);

}  // namespace sightline::inline sweep
