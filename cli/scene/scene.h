// What the command is asked to analyse: a mesh file, which sides of its faces count, the cameras and the panels.
#pragma once

#include <string>
#include <vector>

#include "geometry/projection/camera.h"
#include "geometry/projection/culling.h"
#include "reflect/world/panel.h"
#include "reflect/world/reflection_options.h"

namespace sightline::cli {

struct Scene {
  std::string file;       // the scene file, or the mesh file where the camera came from the command line
  std::string mesh_file;  // a path that can be opened from the working directory
  SidesPolicy sides = SidesPolicy::automatic;
  std::vector<Camera> cameras;  // at least one; names are distinct and safe folder names
  std::vector<Panel> panels;    // names are distinct, and one word each
  ReflectionOptions reflection;
};

}  // namespace sightline::cli
