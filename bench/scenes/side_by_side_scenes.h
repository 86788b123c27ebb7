// The scenes that sightline and its rivals are measured on, in families.
//
// In:  options: which sizes, which families.
// Out: per family the scenes of its table and those for CGAL, smaller ones first, each made when it is needed.
// Holds: no two facets of a scene pass through each other.
// Complexity: making a scene is O(n log n) plus find_contacts for models. Errors: InputError for a model that cannot be
// read.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bench/scenes/side_by_side_options.h"
#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::bench {

struct BenchScene {
  std::shared_ptr<const CutMesh> mesh;
  Camera camera;
  Sides sides = Sides::both;
  std::filesystem::path file;  // where the mesh comes from; empty: generated
  double preparation = 0;      // seconds to find and cut what passes through each other
};

struct SceneMaker {
  std::string label;
  std::function<BenchScene()> make;
};

struct SceneFamily {
  std::string name;    // for the command line
  std::string number;  // in the tables
  std::string title;
  std::string varying;  // what the labels are
  std::vector<SceneMaker> scenes;
  std::vector<SceneMaker> for_cgal;
  bool compares_arithmetic = false;  // exact with double
};

[[nodiscard]] std::vector<SceneFamily> scene_families(const SideBySideOptions& options);

[[nodiscard]] bool is_wanted(const SideBySideOptions& options, const std::string& name);

}  // namespace sightline::bench
