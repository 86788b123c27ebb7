// The built-in scenes of `sightline trace --example`: Fang's, one per degeneracy, and some in which float goes wrong.
//
// Holds: names are distinct words; no two facets of a mesh pass through each other (they are cut); a scene whose
//      arithmetic is not exact is to be shown beside the exact one.
// Source: Fang 1993, section 5.3 (the scene `fang`); stability_families.h (those in float).
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/numbers/arithmetic.h"
#include "geometry/projection/camera.h"
#include "trace/names.h"

namespace sightline::cli {

struct TraceScene {
  CutMesh mesh;
  Camera camera;
  trace::SceneNames names;
  Precision precision;
};

struct TraceExample {
  std::string name;
  std::string title;
  std::string what;  // there is to see
  TraceScene (*make)();
};

[[nodiscard]] const std::vector<TraceExample>& trace_examples();

// Null where there is none of this name.
[[nodiscard]] const TraceExample* trace_example_named(const std::string& name);

}  // namespace sightline::cli
