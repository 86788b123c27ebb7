// Families of scenes with one parameter that goes to its extreme: what `sightline stability` runs, and `sightline trace`
// has some examples of.
//
// Out: for each family its words for the page, the parameter's values in order towards the extreme (all positive, for a
//      logarithmic axis), and the scene for a value.
// Holds: no two faces of a scene pass through each other. Faces that are nearer come later, so that whoever takes two
//      depths for equal, and goes by the lower index, is wrong.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/numbers/image_point.h"
#include "geometry/projection/camera.h"

namespace sightline::cli {

struct FamilyScene {
  Mesh mesh;
  Camera camera;
  int grid_bits = default_grid_bits;
};

struct ExtremeFamily {
  std::string name;  // of its files
  std::string title;
  std::string parameter;  // the axis' label
  std::string scene;      // what is in the scene, and what the parameter does
  std::vector<double> values;
  FamilyScene (*make)(double value);
};

[[nodiscard]] const std::vector<ExtremeFamily>& extreme_families();

}  // namespace sightline::cli
