#include "cli/analyze/memory_estimate.h"

#include "cli/system/memory_limit.h"

namespace sightline::cli {

// Measured with sightline_memory (bench/memory_bench.cpp) on generated surfaces of 10^4 and 10^5 triangles and on meshes
// of public collections. Most is held at once while bands are swept and joined, and while files are written. A height field
// at a grazing angle held 63 and 70 MB then for 149 633 edges, 298 374 corners and 50 176 vertices, where this gives 71 MB,
// and no more from above, with two segments per edge, the most that there are without crossings; the others held less in
// proportion.
std::uint64_t memory_for_view(const ProjectedScene& scene) {
  const CutMesh& mesh = scene.mesh();
  return (std::uint64_t{8} << 20) + 64 * mesh.vertices.size() + 48 * mesh.facets.corners.size() +
         300 * scene.edge_count();
}

void require_memory_for_view(const ProjectedScene& scene, std::uint64_t limit) {
  const std::uint64_t needed = memory_for_view(scene);
  if (needed > limit) throw MemoryError("camera \"" + scene.camera.name + "\"", needed, limit);
}

}  // namespace sightline::cli
