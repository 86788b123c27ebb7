// The meshes of the optional folder of models are found here, with the views of them that tests take.
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/culling.h"

namespace sightline::tests {

[[nodiscard]] std::filesystem::path models_folder();

// The models are in the order of their names; there are none where there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> models();

// Scene files of faces that are nearly degenerate: none where there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> near_degenerate_scenes();

struct Shot {
  Camera camera;
  Sides sides = Sides::both;
};

// One sees all of it from the front, one from within its box, with much behind the eye and across the window's border,
// and one along a diagonal.
[[nodiscard]] std::vector<Shot> shots(const Mesh& mesh);

}  // namespace sightline::tests
