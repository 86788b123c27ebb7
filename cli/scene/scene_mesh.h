// What a scene file says of its meshes, and of the regions of their faces.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh/placement.h"

namespace sightline::cli {

struct SceneMesh {
  std::string file;  // a path that can be opened from the working directory
  std::string name;  // empty only where there is one mesh
  Placement placement;
};

// Regions by their names: of meshes, objects, groups and materials.
struct RegionChoice {
  std::string key;  // of the scene file
  std::vector<std::string> names;
  std::size_t line = 0;
};

// Materials by what their MTL files say: all of what is given here.
struct MaterialChoice {
  std::vector<int> illum;              // one of these; empty: any
  std::optional<double> specular_min;  // the largest component of Ks is no less
  std::size_t line = 0;
};

struct SceneRegions {
  std::optional<RegionChoice> of_interest;
  std::optional<RegionChoice> ignore;
  std::optional<RegionChoice> mirrors;
  std::optional<MaterialChoice> mirrors_material;
};

}  // namespace sightline::cli
