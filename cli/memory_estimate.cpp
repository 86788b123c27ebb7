#include "cli/memory_estimate.h"

#include "cli/memory_limit.h"

namespace sightline {

// Measured with sightline_memory (bench/memory_bench.cpp) on generated surfaces of 10^4 and 10^5 triangles and on meshes
// of public collections. Most is held at once while the results are written. A view of a height field shows nearly two
// segments per edge, the most that there are without crossings: it held 117 MB for 149 633 edges, 298 374 corners and
// 50 176 vertices, where this gives 136 MB; the others held less in proportion.
std::uint64_t memory_for_view(const Mesh& mesh, const ProjectedScene& scene) {
  return (std::uint64_t{10} << 20) + 128 * mesh.vertices.size() + 100 * mesh.facets.corners.size() +
         600 * scene.edge_count();
}

void require_memory_for_view(const Mesh& mesh, const ProjectedScene& scene, std::uint64_t limit) {
  const std::uint64_t needed = memory_for_view(mesh, scene);
  if (needed > limit) throw MemoryError("camera \"" + scene.camera.name + "\"", needed, limit);
}

}  // namespace sightline
