// One mesh and one camera through every stage, each of them timed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/system/progress.h"
#include "formats/reading/read_limits.h"
#include "geometry/cutting/interpenetration.h"
#include "sightline/analyze.h"

namespace sightline::cli {

// What all cameras of a scene share.
struct MeshInput {
  Mesh mesh;                            // cut along the common lines of its facets
  std::vector<Vector3> corner_normals;  // where they were asked for: see ObjFile
  std::vector<std::string> warnings;    // of the reader
  MeshContacts contacts;                // before it was cut
  std::uint64_t max_memory = 0;         // in bytes
  double read_seconds = 0;
  double contacts_seconds = 0;
  double cut_seconds = 0;
};

// Errors: InputError (see read_obj).
[[nodiscard]] MeshInput read_mesh(const std::string& file, Normals normals, std::uint64_t max_memory,
                                  Progress& progress);

// How views are computed; the result differs by sides and precision only.
struct ViewOptions {
  SidesPolicy sides = SidesPolicy::automatic;
  Precision precision;
  Engine engine = Engine::fast;
};

struct StageSeconds {
  double sides = 0;
  double project = 0;
  double sweep = 0;
  double reconstruct = 0;
  double reflect = 0;
  double label = 0;
};

struct ViewAnalysis {
  ViewOptions asked;
  SidesDecision sides;
  View view;
  StageSeconds seconds;
};

// world: of the input's mesh. Without panels nothing is reflected.
// Errors: MemoryError, before the sweep; InternalError, or ArithmeticError where the arithmetic is not exact.
[[nodiscard]] ViewAnalysis analyze_view(const MeshInput& input, const MirrorWorld& world, const Camera& camera,
                                        const ViewOptions& options, Progress& progress);

}  // namespace sightline::cli
