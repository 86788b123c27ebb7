// What the sweep without rounding sees of each face, exactly.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "sweep/unrounded/unrounded_sweep.h"

namespace sightline::tests {

struct UnroundedView {
  ProjectedScene scene;
  VisibleSegments segments;
  UnroundedCounts counts;
};

// The mesh is not cut.
[[nodiscard]] UnroundedView unrounded_view(const CutMesh& mesh, const Camera& camera, Sides sides);
[[nodiscard]] UnroundedView unrounded_view(const Mesh& mesh, const Camera& camera, Sides sides);

struct UnroundedAreas {
  std::vector<boost::multiprecision::cpp_rational> of_face;  // in window units squared
  std::size_t along_swaps = 0;                               // segments along swap edges
  UnroundedCounts counts;
};

// The mesh is not cut.
[[nodiscard]] UnroundedAreas unrounded_areas(const CutMesh& mesh, const Camera& camera, Sides sides);
[[nodiscard]] UnroundedAreas unrounded_areas(const Mesh& mesh, const Camera& camera, Sides sides);

}  // namespace sightline::tests
