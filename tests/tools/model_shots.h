// The meshes of the optional folder of models, and the views of them that tests take.
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/culling.h"

namespace sightline::tests {

[[nodiscard]] std::filesystem::path models_folder();

// In the order of their names; none where there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> models();

struct Shot {
  Camera camera;
  Sides sides = Sides::both;
};

// All of it from the front; from within its box, with much behind the eye and across the window's border; along a
// diagonal.
[[nodiscard]] std::vector<Shot> shots(const Mesh& mesh);

}  // namespace sightline::tests
